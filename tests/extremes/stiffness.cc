// SPDX-License-Identifier: LGPL-2.1-or-later

// Gaps of nothing, penalties, friction and Poisson's ratios from one end to the
// other: BENCHMARKS.md X10, X14, X15, X16.

#include "../support/blocks.h"
#include "../support/rings.h"

#include <cmath>
#include <fstream>
#include <sstream>

using namespace Test;


// X14: a block is pushed onto another from a gap or an overlap of round-off.
TEST(ExtremeStiffness, GapsOfNothing)
{
  unsigned int at_zero = 0;
  double       force   = 0.;
  for (const double gap : {0., 1e-16, -1e-16, 1e-12, -1e-12})
    {
      Blocks b;
      b.overlap    = -gap;
      const auto s = run<3>(
        names("lower, upper", "base, top", "i") +
        body("lower",
             b.box<3>({{0., 0., 0.}}, {{1., 1., 1.}}) + b.lower,
             "Young's modulus = 1000|Poisson's ratio = 0.3") +
        body("upper",
             b.box<3>({{0., 0., 1. + gap}}, {{1., 1., 2.}}) + b.upper,
             "Young's modulus = 1000|Poisson's ratio = 0.3") +
        condition("base", "Body = lower|Boundary ids = 4|x = 0|y = 0|z = 0") +
        condition("top",
                  "Body = upper|Boundary ids = 5|x = 0|y = 0|z = -0.01*t") +
        interface("i",
                  "Secondary = lower: boundary 5|Primary = upper: boundary 4|"
                  "Stiffness scale = 100") +
        solver(1e-11));
      const double f = s->model.interfaces[0]->report().force[2];
      if (gap == 0.)
        {
          at_zero = s->newton_iterations;
          force   = f;
          EXPECT_LT(f, -1.);
        }
      EXPECT_LE(s->newton_iterations, at_zero + 2) << gap;
      EXPECT_NEAR(f, force, 1e-9 * std::abs(force)) << gap;
    }
}


// X14: blocks that only touch, over a face, along an edge or at a corner, and
// are not pushed: no force, at once.
TEST(ExtremeStiffness, TouchingWithoutForce)
{
  for (const auto &shift : {std::array<double, 3>{{0., 0., 1.}},
                            std::array<double, 3>{{1., 0., 1.}},
                            std::array<double, 3>{{1., 1., 1.}}})
    {
      Blocks     b;
      const auto s = run<3>(
        names("lower, upper", "base, top", "i") +
        body("lower",
             b.box<3>({{0., 0., 0.}}, {{1., 1., 1.}}) + b.lower,
             "Young's modulus = 1000") +
        body("upper",
             b.box<3>(shift, {{1. + shift[0], 1. + shift[1], 2.}}) + b.upper,
             "Young's modulus = 1000") +
        condition("base", "Body = lower|Boundary ids = 4|x = 0|y = 0|z = 0") +
        condition("top", "Body = upper|Boundary ids = 5|x = 0|y = 0|z = 0") +
        interface("i",
                  "Kind = automatic single surface|Secondary = lower; upper") +
        solver());
      // overlaps of round-off, 1e-16, are none
      EXPECT_LT(s->model.interfaces[0]->report().force.norm(), 1e-25);
      EXPECT_LE(s->newton_iterations, 2u);
    }
}


// X15: the penetration of a linear law is the pressure over its stiffness, to
// the end; iterations do not grow.
TEST(ExtremeStiffness, Penalties)
{
  unsigned int base = 0;
  for (const double scale : {1e0, 1e-1, 1e1, 1e2, 1e3, 1e4, 1e6, 1e8})
    {
      Blocks b;
      b.overlap = scale < 1. ? 1e-2 : 1e-3 / scale;
      b.contact = "Law = linear|Characteristic length = 0.5|Stiffness = 1000|"
                  "Stiffness side = secondary|Stiffness scale = " +
                  num(scale);
      b.residual   = 1e-9;
      const auto s = run<3>(b.text<3>());
      // p = scale 0.1 K d/l
      const double d = 0.5 / (scale * 0.1 * 1000.);
      EXPECT_NEAR(s->model.interfaces[0]->report().mean_penetration,
                  d,
                  1e-6 * d)
        << scale;
      if (scale == 1.)
        base = s->newton_iterations;
      else
        EXPECT_LE(s->newton_iterations, base + 3) << scale;
    }
}


// X15: a law too soft to carry the pressure before the contact is released is
// no silence: the run ends without convergence, says why, and has saved.
TEST(ExtremeStiffness, TooSoftIsRefused)
{
  Blocks b;
  b.contact = "Law = linear|Characteristic length = 0.5|Stiffness = 1000|"
              "Stiffness scale = 1e-3";
  Log  log(MPI_COMM_WORLD, true);
  auto s = make<3>(b.text<3>() + section("Steps", "Smallest step = 0.01"), log);
  EXPECT_EQ(s->run(), no_convergence);
  EXPECT_LT(s->time, 1.);
  std::ifstream     file(s->scene.output.directory + "/run.log");
  std::stringstream text;
  text << file.rdbuf();
  // pressed through the other block, it is held by nothing
  EXPECT_NE(text.str().find("nothing holds"), std::string::npos);
  EXPECT_TRUE(std::ifstream(s->scene.output.directory + "/checkpoint/state"));
  EXPECT_TRUE(std::isfinite(s->u.linfty_norm()));
}


// X16: a sheared block of one cell (closed form, see verification/friction.cc)
// with coefficients from nothing to a tie.
TEST(ExtremeStiffness, FrictionCoefficients)
{
  // pressure, and compliance of shear and contact in series
  const double p = 7., compliance = 1. / 400. + 1. / 500.;
  const auto   force = [](const std::string &friction) {
    const auto s = run<2>(
      names("block", "down, top", "i") +
      body(
        "block",
        "Lower corner = 0,0|Upper corner = 1,1|Cells = 1,1",
        "Law = linear elastic|Young's modulus = 1000|Poisson's ratio = 0.25") +
      rigid("floor", "Type = plane") +
      condition("down", "Body = block|Boundary ids = 0,1,2,3|y = -0.02") +
      condition("top", "Body = block|Boundary ids = 3|x = 0.05*t") +
      interface(
        "i",
        "Secondary = block: boundary 2|Primary = floor|Stiffness = 1000|"
          "Characteristic length = 0.2|Kind = forming surface to surface|"
          "Release = report" +
          friction) +
      solver(1e-12, 0.25));
    return s->model.reaction(1)[0];
  };
  const auto with = [&](const double mu) {
    return force("|Friction coefficient = " + num(mu));
  };
  EXPECT_EQ(with(0.), force(""));
  EXPECT_NEAR(with(0.), 0., 1e-12);
  EXPECT_NEAR(with(1e-12), 1e-12 * p, 1e-12);
  EXPECT_NEAR(with(0.3), 0.3 * p, 1e-10);
  EXPECT_NEAR(with(1.), p, 1e-10);
  // sticks: 0.05 over the compliance
  for (const double mu : {10., 1e6, 1e12})
    EXPECT_NEAR(with(mu), 0.05 / compliance, 1e-8) << mu;
}


// X10: an inner ring that is nearly incompressible, against Michell's solution;
// no checkerboard in its pressures. A twentieth of the load. The facets match:
// between polygons that do not, the volume that is locked in between them makes
// pressures scatter.
TEST(ExtremeStiffness, NearlyIncompressibleRing)
{
  const double p0 = 0.05 * 1.2156454e7, p2 = 0.05 * 1.3859352e6;
  const auto   s = run<2>(
    rings("Inner radius = 0.2|Outer radius = 0.6|Cells = 48, 16",
          "Law = Mooney-Rivlin|Young's modulus = 1e9|Poisson's ratio = 0.4999",
          "Inner radius = 0.6|Outer radius = 1|Cells = 48, 16",
          linear_steel("1e9", "0.2"),
          ", load") +
    cosine_load() +
    interface("fit",
              "Stiffness = 1e9|Characteristic length = 0.05|Stiffness "
                "scale = 200|Secondary offset = 2e-3|"
                "Initial penetration = ignore|Initial pressure = 1") +
    probe("in", "inner", "0.6, 0") + probe("out", "outer", "0.6, 0") +
    solver(1e-8));
  const auto p = fourier(*s);
  EXPECT_NEAR(p[0], p0, 0.01 * p0);
  EXPECT_NEAR(p[1], p2, 0.03 * p2);
  // pressures of neighbours around the ring, first layer below the contact
  std::vector<std::pair<double, double>> layer;
  for_each_cell(*s, "inner", [&](const auto &x, const CellState &state) {
    if (x.norm() > 0.575)
      layer.emplace_back(std::atan2(x[1], x[0]), -trace(state.stress) / 3.);
  });
  std::sort(layer.begin(), layer.end());
  ASSERT_EQ(layer.size(), 48u);
  double largest = 0.;
  for (std::size_t i = 1; i + 1 < layer.size(); ++i)
    largest = std::max(largest,
                       std::abs(layer[i - 1].second - 2. * layer[i].second +
                                layer[i + 1].second));
  EXPECT_LT(largest, 0.04 * p0);
}
