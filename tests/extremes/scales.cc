// SPDX-License-Identifier: LGPL-2.1-or-later

// Units, places and stiffness ratios: BENCHMARKS.md X1, X2, X4. Reference: the
// same scene in other units, exact states.

#include "../support/blocks.h"
#include "../support/rings.h"

#include <tuple>
#include <vector>

using namespace Test;

namespace
{
  /// Results without units.
  struct Results
  {
    std::vector<double> numbers;
    unsigned int        iterations = 0, pairs = 0;
  };

  template <int dim>
  Results
  results(const Simulation<dim> &s, const double length, const double modulus)
  {
    const auto  &report = s.model.interfaces[0]->report();
    const double force  = modulus * std::pow(length, dim - 1);
    Results      r;
    r.numbers    = {report.largest_penetration / length,
                    report.largest_pressure / modulus,
                    report.force[dim - 1] / force,
                    report.energy / (force * length),
                    report.damage_dissipation / (force * length),
                    report.active_area / std::pow(length, dim - 1)};
    r.iterations = s.newton_iterations;
    r.pairs      = report.active_pairs;
    return r;
  }

  void
  expect_same(const Results &a, const Results &b, const std::string &where)
  {
    for (std::size_t i = 0; i < a.numbers.size(); ++i)
      EXPECT_NEAR(a.numbers[i], b.numbers[i], 1e-9 * std::abs(a.numbers[i]))
        << where << ", number " << i;
    EXPECT_EQ(a.iterations, b.iterations) << where;
    EXPECT_EQ(a.pairs, b.pairs) << where;
  }

  Results
  blocks(const double length, const double modulus)
  {
    Blocks b;
    b.length  = length;
    b.modulus = modulus;
    return results(*run<3>(b.text<3>()), length, modulus);
  }

  /// BENCHMARKS A4 at a twentieth of its load.
  Results
  cosine_rings(const double length, const double modulus)
  {
    const std::string steel = linear_steel(num(modulus * 1e9), "0.2");
    const auto        radii = [&](const double a, const double b) {
      return "Inner radius = " + num(length * a) +
             "|Outer radius = " + num(length * b);
    };
    return results(
      *run<2>(rings(radii(0.2, 0.6) + "|Cells = 12, 3",
                    steel,
                    radii(0.6, 1.) + "|Cells = 16, 3",
                    steel,
                    ", load",
                    "Degree = 2") +
              cosine_load(modulus) +
              interface("fit",
                        "Stiffness scale = 200|Secondary offset = " +
                          num(length * 2e-3) +
                          "|Initial penetration = ignore|Initial pressure = " +
                          num(modulus)) +
              probe("in", "inner", num(0.6 * length) + ", 0") +
              probe("out", "outer", num(0.6 * length) + ", 0") + solver(1e-11)),
      length,
      modulus);
  }

  /// BENCHMARKS A15 a: peak 50 at an opening of 0.05, zero at 0.2.
  Results
  cohesive(const double length, const double modulus)
  {
    const std::string stiff =
      "Law = linear elastic|Young's modulus = " + num(modulus * 1e8) +
      "|Poisson's ratio = 0";
    const std::string l = num(length), l2 = num(2. * length);
    return results(
      *run<2>(names("lower, upper", "base, pull", "glue") +
              body("lower",
                   "Lower corner = 0,0|Upper corner = " + l + "," + l +
                     "|Cells = 2,1",
                   stiff) +
              body("upper",
                   "Lower corner = 0," + l + "|Upper corner = " + l + "," + l2 +
                     "|Cells = 3,1",
                   stiff) +
              condition("base", "Body = lower|Boundary ids = 2|x = 0|y = 0") +
              condition("pull",
                        "Body = upper|Boundary ids = 3|x = 0|y = 0.1*t*" + l) +
              interface(
                "glue",
                "Kind = tiebreak|Secondary = lower: boundary 3|Primary = "
                "upper: boundary 2|Tiebreak = cohesive|Normal strength = " +
                  num(50. * modulus) +
                  "|Shear strength = " + num(50. * modulus) +
                  "|Normal fracture energy = " + num(5. * modulus * length) +
                  "|Shear fracture energy = " + num(5. * modulus * length) +
                  "|Normal tie stiffness = " + num(1000. * modulus / length)) +
              solver(1e-10, 0.1)),
      length,
      modulus);
  }

  class Units : public testing::TestWithParam<std::tuple<double, double>>
  {};
} // namespace


// Length times a, modulus times b: the same numbers, iterations and pairs.
TEST_P(Units, DoNotMatter)
{
  const auto [length, modulus] = GetParam();
  const std::string where      = num(length) + " m, " + num(modulus) + " Pa";
  expect_same(blocks(1., 1.), blocks(length, modulus), "blocks " + where);
  expect_same(cosine_rings(1., 1.),
              cosine_rings(length, modulus),
              "rings " + where);
  expect_same(cohesive(1., 1.), cohesive(length, modulus), "glue " + where);
}

INSTANTIATE_TEST_SUITE_P(Some,
                         Units,
                         testing::Values(std::make_tuple(1e-9, 1e9),
                                         std::make_tuple(1e9, 1e-9),
                                         std::make_tuple(1e-9, 1e-9),
                                         std::make_tuple(1e9, 1e9)));

INSTANTIATE_TEST_SUITE_P(
  All,
  Units,
  testing::Combine(testing::Values(1e-9, 1e-6, 1e-3, 1., 1e3, 1e6, 1e9),
                   testing::Values(1e-9, 1e-6, 1e-3, 1., 1e3, 1e6, 1e9)));


// X2: only the digits that the coordinates lose. The mesh itself is known to
// eps |x|, its overlap of 1e-3 and facets to that, too.
TEST(ExtremeScales, BlocksFarFromTheOrigin)
{
  const Blocks       near;
  const auto         s     = run<3>(near.text<3>());
  const unsigned int pairs = s->model.interfaces[0]->report().active_pairs;
  const double       h     = 1. / 3.;
  for (const double offset : {1e2, 1e4, 1e6, 1e8})
    {
      Blocks far;
      far.origin   = offset * h;
      far.residual = std::max(1e-12, 1e-16 * offset / 1e-3);
      const auto t = run<3>(far.text<3>());
      EXPECT_LT(far.stress_error<3>(*t), 1e-10 + 100. * 2.2e-16 * offset)
        << offset;
      if (offset <= 1e6)
        {
          EXPECT_EQ(t->model.interfaces[0]->report().active_pairs, pairs)
            << offset;
        }
    }
}


// X4: the patch test with blocks that are softer or stiffer by up to a million.
TEST(ExtremeScales, SoftOnStiffBlocks)
{
  for (const double ratio : {1e-6, 1e-3, 1e-1, 1e1, 1e3, 1e6})
    {
      // without contraction: blocks of different width are no patch test
      Blocks b;
      b.nu         = 0.;
      b.ratio      = ratio;
      b.residual   = 1e-10;
      const auto s = run<3>(b.text<3>());
      // at a million the direct solver has seven digits left
      const bool is_far = ratio < 1e-5 || ratio > 1e5;
      EXPECT_LT(b.stress_error<3>(*s), is_far ? 1e-6 : 1e-8) << ratio;
    }
}


// X4: rings of which one is 1e6 times stiffer, against Michell's solution with
// a rigid ring (bench/rings_cos2theta.csv); a twentieth of the load. The faces
// are polygons, 96 and 128 to a quarter: what is left of their gaps, 1e-9 of
// the radius, times the penalty is the noise of the pressures.
TEST(ExtremeScales, RigidRings)
{
  for (const bool is_inner : {true, false})
    {
      const std::string stiff = linear_steel("1e15", "0.2");
      const std::string soft  = linear_steel("1e9", "0.2");
      const auto        s =
        run<2>(rings("Inner radius = 0.2|Outer radius = 0.6|Cells = 96, 6",
                     is_inner ? stiff : soft,
                     "Inner radius = 0.6|Outer radius = 1|Cells = 128, 6",
                     is_inner ? soft : stiff,
                     ", load",
                     "Degree = 2") +
               cosine_load() +
               interface("fit",
                         "Stiffness = 1e9|Characteristic length = 0.05|"
                         "Stiffness scale = 200|Secondary offset = 2e-3|"
                         "Initial penetration = ignore|Initial pressure = 1") +
               probe("in", "inner", "0.6, 0") +
               probe("out", "outer", "0.6, 0") + solver(1e-7));
      const auto   p    = fourier(*s);
      const double load = 0.05;
      if (is_inner)
        {
          EXPECT_NEAR(p[0], load * 1.3157890e7, 0.01 * load * 1.3157890e7);
          EXPECT_NEAR(p[1], load * 1.6021159e6, 0.03 * load * 1.6021159e6);
        }
      else
        // 40 and 9 Pa under 1e7 and 1e6: the stiff ring carries it all
        EXPECT_LT(std::abs(p[0]), 2e-2 * load * 1e7);
    }
}
