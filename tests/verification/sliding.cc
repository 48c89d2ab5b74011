// SPDX-License-Identifier: LGPL-2.1-or-later

// Newton's convergence while a punch slides (THEORY D2, T21), and the removal
// of initial penetrations over time (T43).

#include "../support/run_scene.h"

#include <iostream>

using namespace Test;

namespace
{
  template <int dim>
  unsigned int
  most_iterations(const std::string &text)
  {
    Log                       log(MPI_COMM_WORLD, true);
    auto                      s = make<dim>(text, log);
    std::vector<unsigned int> counts;
    s->after_step = [&](Simulation<dim> &now) {
      counts.push_back(now.last_newton.iterations);
    };
    EXPECT_EQ(s->run(), finished);
    EXPECT_EQ(s->cut_backs, 0u);
    std::cout << dim << "d, iterations per step:";
    for (const auto c : counts)
      std::cout << " " << c;
    std::cout << std::endl;
    return *std::max_element(counts.begin(), counts.end());
  }

  const std::string soft =
    "Law = neo-Hookean|Young's modulus = 1e3|Poisson's ratio = 0.3";
  const std::string stiff =
    "Law = neo-Hookean|Young's modulus = 1e4|Poisson's ratio = 0.3";
  const std::string steps = section("Steps", "End time = 2|First step = 0.1");
} // namespace


TEST(Sliding, PunchNeedsAtMostFiveIterationsIn2d)
{
  EXPECT_LE(
    most_iterations<2>(
      names("block, punch", "base, top", "i") +
      body("block",
           "Lower corner = 0,0|Upper corner = 4,1|Cells = 40,10",
           soft) +
      body("punch",
           "Lower corner = 1,1|Upper corner = 2,1.5|Cells = 14,7",
           stiff) +
      condition("base", "Body = block|Boundary ids = 2|x = 0|y = 0") +
      condition("top",
                "Body = punch|Boundary ids = 3|x = if(t<1, 0, t-1)|"
                "y = if(t<1, -0.05*t, -0.05)") +
      interface(
        "i", "Secondary = block: boundary 3|Primary = punch: boundary 0,1,2") +
      solver(1e-10, 0.1) + steps),
    5u);
}


namespace
{
  /// Largest second difference of the force over its mean while the punch
  /// slides, by integration; and Newton iterations.
  std::pair<double, unsigned int>
  roughness(const std::string &integration)
  {
    Log  log(MPI_COMM_WORLD, true);
    auto s = make<2>(
      names("block, punch", "base, top", "i") +
        body("block",
             "Lower corner = 0,0|Upper corner = 4,1|Cells = 40,10",
             soft) +
        body("punch",
             "Lower corner = 1,0|Upper corner = 2,1|Cells = 14,7|Map = x; "
             "(1+0.4*(x-1.5)^2)*(1-y)+1.5*y",
             stiff) +
        condition("base", "Body = block|Boundary ids = 2|x = 0|y = 0") +
        condition("top",
                  "Body = punch|Boundary ids = 3|x = if(t<1, 0, 0.5*(t-1))|"
                  "y = if(t<1, -0.05*t, -0.05)") +
        interface("i",
                  "Secondary = block: boundary 3|Primary = punch: boundary 2|"
                  "Kind = forming surface to surface|Stiffness scale = 20|"
                  "Release = report|" +
                    integration) +
        "subsection Solver\nsubsection Newton\nset Maximum iterations = "
        "200\nend\nend\n" +
        section("Steps", "End time = 2|First step = 0.02|Times to meet = 1"),
      log);
    std::vector<double> forces;
    s->after_step = [&](Simulation<2> &now) {
      if (now.time > 1.01)
        forces.push_back(now.model.interfaces[0]->report().force[1]);
    };
    EXPECT_EQ(s->run(), finished);
    double largest = 0., sum = 0.;
    for (std::size_t i = 1; i + 1 < forces.size(); ++i)
      {
        largest =
          std::max(largest,
                   std::abs(forces[i + 1] - 2. * forces[i] + forces[i - 1]));
        sum += std::abs(forces[i]);
      }
    return {largest * (forces.size() - 2) / sum, s->newton_iterations};
  }
} // namespace


// What users have today, for comparison: the force of node-to-segment contact
// jumps where nodes cross edges.
TEST(Sliding, SegmentsAreSmootherThanNodes)
{
  const auto segments = roughness("Integration = segments");
  const auto points   = roughness("Integration = points");
  const auto nodes    = roughness("Integration = nodes");
  std::cout << "second difference over mean force, iterations: segments "
            << segments.first << " " << segments.second << ", points "
            << points.first << " " << points.second << ", nodes " << nodes.first
            << " " << nodes.second << std::endl;
  EXPECT_LT(5. * segments.first, nodes.first);
}


TEST(Sliding, PunchNeedsAtMostFiveIterationsIn3d)
{
  EXPECT_LE(
    most_iterations<3>(
      names("block, punch", "base, top", "i") +
      body("block",
           "Lower corner = 0,0,0|Upper corner = 3,2,1|Cells = 12,8,4",
           soft) +
      body("punch",
           "Lower corner = 0.6,0.6,1|Upper corner = 1.4,1.4,1.5|Cells = 5,5,3",
           stiff) +
      condition("base", "Body = block|Boundary ids = 4|x = 0|y = 0|z = 0") +
      condition("top",
                "Body = punch|Boundary ids = 5|x = if(t<1, 0, t-1)|y = 0|"
                "z = if(t<1, -0.06*t, -0.06)") +
      interface(
        "i",
        "Secondary = block: boundary 5|Primary = punch: boundary 0,1,2,3,4") +
      solver(1e-10, 0.1) + steps),
    5u);
}


namespace
{
  /// Two bars that overlap by 0.02 at the start, ends held; nu = 0.
  std::string
  overlapping_bars(const std::string &treatment)
  {
    return names("lower, upper", "base, top", "i") +
           body(
             "lower",
             "Lower corner = 0,0|Upper corner = 1,1|Cells = 2,2",
             "Law = linear elastic|Young's modulus = 1000|Poisson's ratio = 0") +
           body(
             "upper",
             "Lower corner = 0,0.98|Upper corner = 1,2.98|Cells = 3,2",
             "Law = linear elastic|Young's modulus = 300|Poisson's ratio = 0") +
           condition("base", "Body = lower|Boundary ids = 2|x = 0|y = 0") +
           condition("top", "Body = upper|Boundary ids = 3|x = 0|y = 0") +
           interface(
             "i",
             "Secondary = lower: boundary 3|Primary = upper: boundary 2|"
             "Stiffness = 500|Characteristic length = 0.5|"
             "Stiffness side = secondary|" +
               treatment) +
           solver(1e-12, 0.25);
  }

  /// p with bars p + d(p) = overlap: the parabola of the law.
  double
  bar_pressure(const double overlap)
  {
    const double bars = 1. / 1000. + 2. / 300.;
    const double c    = 0.1 * 500. / (4. * 0.03 * 0.25);
    const double d =
      (-1. + std::sqrt(1. + 4. * bars * c * overlap)) / (2. * bars * c);
    return c * d * d;
  }
} // namespace


TEST(Removal, PressureFollowsTheRemovedOverlapInTime)
{
  // THEORY T43: p(t) C + d(p) = d0 t / MPAR1, exact in time; afterwards the
  // same as true interference (treatment stress)
  for (const std::string kind : {"remove over time|Removal time = 0.5",
                                 "remove over time deep|Removal time = 0.5|"
                                 "Deepest initial penetration = 0.03"})
    {
      Log  log(MPI_COMM_WORLD, true);
      auto s = make<2>(overlapping_bars("Initial penetration = " + kind), log);
      unsigned int n = 0;
      s->after_step  = [&](Simulation<2> &now) {
        const double p = bar_pressure(0.02 * std::min(1., now.time / 0.5));
        EXPECT_NEAR(-now.model.interfaces[0]->report().force[1], p, 1e-9 * p);
        ++n;
      };
      ASSERT_EQ(s->run(), finished);
      EXPECT_EQ(n, 4u);
    }
  const auto s = run<2>(overlapping_bars("Initial penetration = stress"));
  EXPECT_NEAR(-s->model.interfaces[0]->report().force[1],
              bar_pressure(0.02),
              1e-9 * bar_pressure(0.02));
}


namespace
{
  /// A quarter of a rubber ring (bore 20) on a rigid tube; nothing moves.
  std::string
  ring_on_tube(const double       radius,
               const std::string &treatment,
               const double       step)
  {
    return names("ring", "planes", "fit") +
           body("ring",
                "Type = revolution|Inner radius = 20|Outer radius = 26|"
                "Last angle = 90|Length = 5|Cells = 24,6,2",
                "Law = Mooney-Rivlin|C10 = 0.4|C01 = 0.1|"
                "Poisson's ratio = 0.49") +
           rigid("tube", "Type = cylinder|Radius = " + num(radius)) +
           condition("planes",
                     "Body = ring|Boundary ids = 0,1,4,5|Type = symmetry") +
           interface("fit",
                     "Secondary = ring: boundary 2|Primary = tube|"
                     "Law = linear|Stiffness scale = 10|"
                     "Initial penetration = " +
                       treatment) +
           solver(1e-9, step);
  }
} // namespace


// LS-DYNA's manual, IGNORE = 1: no force while penetrations do not exceed those
// of the start. Nothing moves here, so steps must not matter; before, levels
// crept until all of the interference pressed.
TEST(Removal, TrackedPenetrationsOfCurvedBodiesDoNotCreep)
{
  const auto force = [](const std::string &treatment, const double step) {
    const auto s = run<3>(ring_on_tube(20.5, treatment, step));
    return s->model.interfaces[0]->report().force.norm();
  };
  const double all = force("stress", 1.), few = force("track", 0.5),
               many = force("track", 0.05);
  EXPECT_LT(few, 0.02 * all);
  EXPECT_NEAR(many, few, 1e-6 * all);
}


TEST(Removal, OverlapsManyTimesTheReleaseDepthAreTold)
{
  for (const double radius : {21., 22., 23., 25.})
    {
      Log        log(MPI_COMM_WORLD, true);
      const auto s       = make<3>(ring_on_tube(radius, "stress", 1.), log);
      const auto initial = s->model.interfaces[0]->report().initial;
      EXPECT_EQ(initial.n_undetected, 24u * 2u);
      // the ring's facets are chords: the middle is deepest
      EXPECT_NEAR(initial.undetected.penetration, radius - 20., 0.05);
    }
}


TEST(Invariance, UnitsAndRotationDoNotMatter)
{
  // the same scene in m, in mm and MPa, and turned by 30 degrees
  const auto scene = [](const double L, const double P, const double angle) {
    const auto corner = [&](const double x, const double y) {
      return num(L * x) + "," + num(L * y);
    };
    const double      c = std::cos(angle), s = std::sin(angle);
    const std::string turn =
      "|Rotation angle = " + num(angle * 180. / numbers::PI);
    const auto E = [&](const double e) {
      return "Law = neo-Hookean|Young's modulus = " + num(P * e) +
             "|Poisson's ratio = 0.3";
    };
    // press by (0.02, -0.05) in the scene's own directions
    const double ux = L * (c * 0.02 + s * 0.05), uy = L * (s * 0.02 - c * 0.05);
    return names("block, punch", "base, top", "i", "p") +
           body("block",
                "Lower corner = 0,0|Upper corner = " + corner(2, 1) +
                  "|Cells = 16,8" + turn,
                E(1e9)) +
           body("punch",
                "Lower corner = " + corner(0.5, 1) + "|Upper corner = " +
                  corner(1.5, 1.5) + "|Cells = 10,5" + turn,
                E(3e9)) +
           condition("base", "Body = block|Boundary ids = 2|x = 0|y = 0") +
           condition("top",
                     "Body = punch|Boundary ids = 3|x = " + num(ux) +
                       "*t|y = " + num(uy) + "*t") +
           interface(
             "i", "Secondary = block: boundary 3|Primary = punch: boundary 2") +
           probe("p",
                 "block",
                 num(L * (c * 1. - s * 1.)) + "," +
                   num(L * (s * 1. + c * 1.))) +
           solver(1e-11, 0.5);
  };
  const auto metres = run<2>(scene(1., 1., 0.));
  const auto force  = metres->model.interfaces[0]->report().force;
  const auto u      = metres->probe(0);
  {
    const auto mm = run<2>(scene(1000., 1e-6, 0.));
    EXPECT_LT((mm->probe(0) / 1000. - u).norm(), 1e-10 * u.norm());
    EXPECT_LT((mm->model.interfaces[0]->report().force * 1e3 - force).norm(),
              1e-10 * force.norm());
    EXPECT_EQ(mm->newton_iterations, metres->newton_iterations);
  }
  {
    const double       a      = numbers::PI / 6.;
    const auto         turned = run<2>(scene(1., 1., a));
    const auto         v      = turned->probe(0);
    const Tensor<1, 2> back({std::cos(a) * v[0] + std::sin(a) * v[1],
                             -std::sin(a) * v[0] + std::cos(a) * v[1]});
    EXPECT_LT((back - u).norm(), 1e-10 * u.norm());
    EXPECT_EQ(turned->newton_iterations, metres->newton_iterations);
  }
}
