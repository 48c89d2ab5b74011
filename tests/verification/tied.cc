// SPDX-License-Identifier: LGPL-2.1-or-later

// Ties and friction pass uniform stress through meshes that do not match
// (THEORY T18, BENCHMARKS A1 f).

#include "../support/run_scene.h"

#include <cmath>

using namespace Test;

namespace
{
  const std::string glued_material =
    "Law = linear elastic|Young's modulus = 1000|Poisson's ratio = 0.3";
  const double G = 1000. / 2.6;

  template <int dim>
  void
  expect_uniform(const Simulation<dim>       &s,
                 const SymmetricTensor<2, 3> &expected,
                 const double                 tolerance)
  {
    for (const auto &b : s.model.bodies)
      for_each_cell(s, b->name, [&](const auto &x, const auto &state) {
        EXPECT_LT((state.stress - expected).norm(), tolerance * expected.norm())
          << b->name << " " << x;
      });
  }
} // namespace


// The stress is that of simple shear or tension; the tie opens by
// 2 t l/(alpha K), both sides in series: alpha K/l = 0.1 1e5/0.1 = 1e5.
TEST(Tied, PatchTestOfTensionAndShear)
{
  const std::string scene =
    body("lower",
         "Lower corner = 0,0,0|Upper corner = 1,1,1|Cells = 3,3,2",
         glued_material) +
    body("upper",
         "Lower corner = 0,0,1|Upper corner = 1,1,2|Cells = 4,2,2",
         glued_material) +
    interface("i",
              "Kind = tied|Secondary = upper: boundary 4|Primary = lower: "
              "boundary 5|Stiffness = 1e5|Characteristic length = 0.1");
  {
    // tension 10: free to contract
    const auto s = run<3>(
      names("lower, upper", "base, x, y, top, x2, y2", "i") + scene +
      condition("base", "Body = lower|Boundary ids = 4|z = 0") +
      condition("x", "Body = lower|Boundary ids = 0|x = 0") +
      condition("y", "Body = lower|Boundary ids = 2|y = 0") +
      condition("x2", "Body = upper|Boundary ids = 0|x = 0") +
      condition("y2", "Body = upper|Boundary ids = 2|y = 0") +
      condition("top", "Body = upper|Boundary ids = 5|Type = traction|z = 10") +
      solver(1e-13));
    SymmetricTensor<2, 3> stress;
    stress[2][2] = 10.;
    expect_uniform(*s, stress, 1e-9);
    EXPECT_NEAR(s->model.interfaces[0]->report().largest_tie_jump,
                20. / 1e5,
                1e-12);
  }
  {
    // shear 10 in the plane of the tie: u_x = 10 z/G, plus the jump
    std::ostringstream lower, upper;
    lower.precision(17);
    upper.precision(17);
    lower << 10. / G << "*z";
    upper << 10. / G << "*z+" << 20. / 1e5;
    const auto s = run<3>(
      names("lower, upper", "base, sides, top, sides2", "i") + scene +
      condition("base",
                "Body = lower|Boundary ids = 0,1,2,3,4|x = " + lower.str() +
                  "|y = 0|z = 0") +
      condition("top",
                "Body = upper|Boundary ids = 0,1,2,3,5|x = " + upper.str() +
                  "|y = 0|z = 0") +
      condition("sides", "Body = lower|Boundary ids = 5|z = 0") +
      condition("sides2", "Body = upper|Boundary ids = 4|z = 0") +
      solver(1e-13));
    SymmetricTensor<2, 3> stress;
    stress[0][2] = 10.;
    expect_uniform(*s, stress, 1e-6);
    EXPECT_NEAR(s->model.interfaces[0]->report().largest_tie_jump,
                20. / 1e5,
                1e-9);
  }
}


// BENCHMARKS A1 (f): interface inclined by 30 degrees, mu = 1: it sticks and
// passes normal and shear stress. The elastic slip and the penetration move the
// outlines by 1e-7, so much of the stress is missing at the ends.
TEST(Tied, InclinedInterfaceSticksByFriction)
{
  const std::string slope = "0.5773502691896258*(x-0.5)";
  const auto        s     = run<2>(
    names("lower, upper", "base, left, top", "i") +
    body("lower",
         "Lower corner = 0,0|Upper corner = 1,1|Cells = 3,3|Map = x; y*(1+" +
           slope + ")",
         "Law = linear elastic|Young's modulus = 1000|Poisson's ratio = 0") +
    body("upper",
         "Lower corner = 0,0|Upper corner = 1,1|Cells = 4,3|Map = x; 1+" +
           slope + "+y*(1-" + slope + ")",
         "Law = linear elastic|Young's modulus = 1000|Poisson's ratio = 0") +
    condition("base", "Body = lower|Boundary ids = 2|y = 0|x = 0") +
    condition("left", "Body = upper|Boundary ids = 3|x = 0") +
    condition("top", "Body = upper|Boundary ids = 3|Type = traction|y = -1") +
    interface(
      "i",
      "Secondary = upper: boundary 2|Primary = lower: boundary 3|Law = "
                 "linear|Stiffness scale = 1e4|Friction coefficient = 1|Secondary offset = 1e-6|"
                 "Characteristic length = 0.1|Initial penetration = ignore|"
                 "Initial pressure = 1e-3") +
    solver(1e-9, 0.1));
  SymmetricTensor<2, 3> stress;
  stress[1][1] = -1.;
  expect_uniform(*s, stress, 1e-5);
}
