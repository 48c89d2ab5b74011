// SPDX-License-Identifier: LGPL-2.1-or-later

// Curved contact with closed-form references: BENCHMARKS.md A3a, A4, A5, A17
// and SHELL_AND_FLUID.md section 7.

#include "../support/rings.h"

using namespace Test;


TEST(Curved, RingsUnderCosinePressure)
{
  // A4 (code_aster SSNP167, re-derived by Michell's solution):
  // p = 9259259.26 + 1357179.1 cos 2 theta. Non-matching, 0.5 %. A twentieth of
  // the load: the reference is for small strains, and at full load the moved
  // interface changes p0 by 0.9 % and p2 by 4.5 % (measured: linear in the
  // load). Facets of different lengths on one circle do not touch everywhere at
  // the start; the offset closes these gaps, the treatment `ignore` makes them
  // stress-free.
  const auto s =
    run<2>(rings("Inner radius = 0.2|Outer radius = 0.6|Cells = 96, 8",
                 linear_steel("1e9", "0.2"),
                 "Inner radius = 0.6|Outer radius = 1|Cells = 128, 8",
                 linear_steel("1e9", "0.2"),
                 ", load",
                 "Degree = 2") +
           cosine_load() +
           interface("fit",
                     "Stiffness scale = 2000|Secondary offset = 2e-3|"
                     "Initial penetration = ignore|Initial pressure = 1") +
           probe("in", "inner", "0.6, 0") + probe("out", "outer", "0.6, 0") +
           solver(1e-9));
  const auto   p    = fourier(*s);
  const double load = 0.05;
  EXPECT_NEAR(p[0], load * 9259259.26, 0.005 * load * 9259259.26);
  EXPECT_NEAR(p[1], load * 1357179.1, 0.005 * load * 1357179.1);
  EXPECT_NEAR(s->probe(1)[0], load * -7.17366e-3, 0.005 * load * 7.17366e-3);
}


TEST(Curved, InterferenceFitsOfElasticTubes)
{
  struct Case
  {
    const char *a, *b_inner, *b_outer, *c, *E, *nu;
    double      p, u_in, u_out, tolerance;
  };
  const Case cases[] = {
    // A5a, Ansys VM292: p = E d (c^2-b^2)(b^2-a^2) / (2 b^3
    // (c^2-a^2)), 2.21638e8
    // for d = 0.02; a tenth of it, for with 0.02 the overlapping walls are 4
    // %
    // thicker than those of the formula
    {"1.25", "1.517", "1.515", "1.75", "206e9", "0", 2.21638e7, 0., 0., 0.01},
    // A5b, steel, plane strain
    {"20",
     "40.025",
     "39.975",
     "60",
     "210000",
     "0.3",
     67.6082,
     -0.0145089,
     0.0354911,
     0.01}};
  for (const Case &c : cases)
    {
      const auto s = run<2>(
        rings(std::string("Inner radius = ") + c.a +
                "|Outer radius = " + c.b_inner + "|Cells = 16, 6",
              linear_steel(c.E, c.nu),
              std::string("Inner radius = ") + c.b_outer +
                "|Outer radius = " + c.c + "|Cells = 16, 6",
              linear_steel(c.E, c.nu),
              "",
              "Degree = 2") +
        interface(
          "fit",
          "Stiffness scale = 2000|Initial penetration = remove over time deep|"
          "Removal time = 1|Deepest initial penetration = 0.06") +
        probe("in", "inner", std::string(c.b_inner) + ", 0") +
        probe("out", "outer", std::string(c.b_outer) + ", 0") + solver(1e-9));
      EXPECT_NEAR(fourier(*s)[0], c.p, c.tolerance * c.p);
      if (c.u_in != 0.)
        {
          EXPECT_NEAR(s->probe(0)[0], c.u_in, 0.01 * std::abs(c.u_in));
          EXPECT_NEAR(s->probe(1)[0], c.u_out, 0.01 * c.u_out);
        }
    }
}


TEST(Curved, InterferenceFitAtFiniteStrain)
{
  // A5c, neo-Hookean tubes 1..2 and 1.8..3, overlap 0.2: interface r
  // = 1.937886, p = 0.296617, inner radius 0.933392, outer 3.102346 (ODE); 0.5
  // %
  const std::string rubber =
    "Law = neo-Hookean|Young's modulus = 10|Poisson's ratio = 0.3";
  const auto s = run<2>(
    rings("Inner radius = 1|Outer radius = 2|Cells = 16, 8",
          rubber,
          "Inner radius = 1.8|Outer radius = 3|Cells = 16, 8",
          rubber,
          "",
          "Degree = 2") +
    interface(
      "fit",
      "Stiffness scale = 1000|Initial penetration = remove over time deep|"
      "Removal time = 1|Deepest initial penetration = 0.25") +
    probe("in", "inner", "1, 0") + probe("out", "outer", "3, 0") +
    solver(1e-9, 0.25));
  EXPECT_NEAR(fourier(*s)[0], 0.296617, 0.005 * 0.296617);
  EXPECT_NEAR(1. + s->probe(0)[0], 0.933392, 0.005 * 0.933392);
  EXPECT_NEAR(3. + s->probe(1)[0], 3.102346, 0.005 * 3.102346);
}


TEST(Curved, IncompressibleRingInARigidBore)
{
  // SHELL_AND_FLUID.md 7: A = 12, B = 20, bore B - delta, mu = 1:
  // p/mu = ln(A/a) - C/(2 a^2) - ln(B/b) + C/(2 b^2); 0.5 %
  for (const double delta : {0.2, 0.5, 1.0})
    {
      const double b = 20. - delta, C = b * b - 400., a = std::sqrt(144. + C);
      const double exact = std::log(12. / a) - C / (2. * a * a) -
                           std::log(20. / b) + C / (2. * b * b);
      const auto s = run<2>(
        rings("Inner radius = 12|Outer radius = 20|Cells = 24, 16",
              "Law = Mooney-Rivlin|C10 = 0.5|Poisson's ratio = 0.4998",
              "Inner radius = " + std::to_string(b) +
                "|Outer radius = 28|Cells = 24, 1",
              linear_steel("1e6", "0.3"),
              ", rigid") +
        condition("rigid", "Body = outer|Boundary ids = 2, 3|x = 0|y = 0") +
        interface("fit",
                  "Stiffness scale = 100|Stiffness side = secondary|"
                  "Initial penetration = remove over time deep|"
                  "Removal time = 1|Deepest initial penetration = 1.1") +
        probe("in", "inner", "12, 0") + probe("out", "outer", "28, 0") +
        solver(1e-8, 0.25));
      EXPECT_NEAR(fourier(*s)[0], exact, 0.005 * exact) << delta;
      EXPECT_NEAR(12. + s->probe(0)[0], a, 0.005 * (12. - a)) << delta;
    }
}


TEST(Curved, SphereOnPlaneFollowsHertz)
{
  // A3a (Ansys VM63): R = 8, E = 1000, nu = 0.3, F = 188.5 -> a = 1.0096.
  // Displacement-controlled around that force; a(F) of Hertz, 2 %
  const auto s = run<3>(
    names("sphere, plane", "symmetry, press, rigid", "i") +
    body("sphere",
         "Type = ball sector|Radius = 8|Refinements = 2|Refine near = 0,0,8|"
         "Refine radius = 6|Local refinements = 3",
         linear_steel("1000", "0.3")) +
    body("plane",
         "Lower corner = -1,-1,8|Upper corner = 4,4,9|Cells = 5,5,1",
         linear_steel("1000", "0.3")) +
    condition("symmetry", "Body = sphere|Boundary ids = 1|Type = symmetry") +
    condition("press",
              "Body = plane|Boundary ids = 4, 5|x = 0|y = 0|z = -0.12*t") +
    condition(
      "rigid",
      "Body = plane|Boundary ids = 0, 1, 2, 3|x = 0|y = 0|z = -0.12*t") +
    interface(
      "i",
      "Secondary = sphere: boundary 0|Primary = plane: boundary 4|"
      "Kind = forming surface to surface|Law = linear|Stiffness scale = 200") +
    solver(1e-8, 0.25));
  const auto  &r = s->model.interfaces[0]->report();
  const double F = 4. * std::abs(r.force[2]);
  // radius from the pressure's second moment, 2/5 a^2 for Hertz: no cut at the
  // edges of facets
  double moment = 0., sum = 0.;
  for (const auto &f :
       MortarContact::facet_states(*s->model.interfaces[0], MPI_COMM_WORLD))
    if (f.side == 0)
      for (unsigned int v = 0; v < f.current.n_vertices; ++v)
        {
          const double share = MortarContact::area(f.current) /
                               f.current.n_vertices * f.pressure[v];
          const auto &x = f.current.x[v];
          sum += share;
          moment += share * (x[0] * x[0] + x[1] * x[1]);
        }
  const double a     = std::sqrt(2.5 * moment / sum);
  const double hertz = std::cbrt(0.75 * F * 8. * (1. - 0.09) / 1000.);
  EXPECT_NEAR(F, 188.5, 20.);
  EXPECT_NEAR(a, hertz, 0.02 * hertz);
}


TEST(Curved, RubberCylinderBetweenPlates)
{
  // A17 (Ansys VM201, Sussman & Bathe): F = 250 N/mm at 100 mm (2 %; CalculiX
  // 248.7), 1400 N/mm at 200 mm (4 %)
  Log  log(MPI_COMM_WORLD, true);
  auto s = make<2>(
    names("disc, plate", "symmetry, press", "i") +
      body(
        "disc",
        "Type = ball sector|Radius = 200|Refinements = 4",
        "Law = Mooney-Rivlin|C10 = 0.293|C01 = 0.177|Poisson's ratio = 0.49967") +
      body("plate",
           "Lower corner = 0,200|Upper corner = 420,220|Cells = 42,1",
           linear_steel("1000", "0.3")) +
      condition("symmetry", "Body = disc|Boundary ids = 1|Type = symmetry") +
      condition(
        "press",
        "Body = plate|Boundary ids = 0, 1, 2, 3|x = 0|y = if(t<1,-50*t,-50*t)") +
      interface("i",
                "Secondary = disc: boundary 0|Primary = plate: boundary 2|"
                "Kind = forming surface to surface|Stiffness scale = 5") +
      solver(1e-7, 0.05) +
      section(
        "Steps",
        "End time = 2|First step = 0.05|Smallest step = 1e-3|Times to meet = 1"),
    log);
  double at_100 = 0.;
  s->after_step = [&](Simulation<2> &now) {
    if (std::abs(now.time - 1.) < 1e-9)
      at_100 = 2. * std::abs(now.model.interfaces[0]->report().force[1]);
  };
  ASSERT_EQ(s->run(), finished);
  EXPECT_NEAR(at_100, 250., 5.);
  EXPECT_NEAR(2. * std::abs(s->model.interfaces[0]->report().force[1]),
              1400.,
              56.);
}
