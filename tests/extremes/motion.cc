// SPDX-License-Identifier: LGPL-2.1-or-later

// Long ways, long and short steps, bodies that only contact holds:
// BENCHMARKS.md X8, X18, X22. Reference: Coulomb's law, impulse and energy of
// an impact.

#include "../support/run_scene.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <sstream>

using namespace Test;

namespace
{
  class LongWay : public testing::TestWithParam<unsigned int>
  {};
} // namespace


// X8: a block slides over facets of 0.1, as many as the parameter says, and
// back over a third of them; steps from half a facet to ten. T = mu N, and the
// dissipation is mu N times the way.
TEST_P(LongWay, FrictionDoesNotDependOnSteps)
{
  // see verification/friction.cc
  const double pressure = 7., mu = 0.3, compliance = 1. / 400. + 1. / 500.;
  const double way = 0.1 * GetParam();
  for (const double facets : {0.5, 3., 10.})
    {
      const double      step  = 0.1 * facets / way;
      const double      first = 0.75; // forth until then, a third back
      const std::string x = num(way / first) + "*if(t<" + num(first) + ", t, " +
                            num(2. * first) + "-t)";
      Log  log(MPI_COMM_WORLD, true);
      auto s = make<2>(
        names("block, ground", "down, top, fixed", "i") +
          body("block",
               "Lower corner = 0,0|Upper corner = 1,1|Cells = 1,1",
               "Law = linear elastic|Young's modulus = 1000|Poisson's "
               "ratio = 0.25") +
          body("ground",
               "Lower corner = -0.95,-1|Upper corner = " + num(way + 1.95) +
                 ",0|Cells = " + std::to_string(GetParam() + 29) + ",1",
               "Law = linear elastic|Young's modulus = 1000") +
          condition("down", "Body = block|Boundary ids = 0,1,2,3|y = -0.02") +
          condition("top", "Body = block|Boundary ids = 3|x = " + x) +
          condition("fixed",
                    "Body = ground|Boundary ids = 0,1,2,3|x = 0|y = 0") +
          interface("i",
                    "Secondary = block: boundary 2|Primary = ground: boundary "
                    "3|Stiffness = 1000|Characteristic length = 0.2|Kind = "
                    "forming surface to surface|Release = report|"
                    "Friction coefficient = 0.3") +
          solver(1e-11, step) +
          section("Steps", "Times to meet = " + num(first)),
        log);
      double largest_error = 0.;
      s->after_step        = [&](Simulation<2> &now) {
        // slides once both springs are stretched, at the start and after
        // turning
        const double moved = way / first * std::abs(now.time - first);
        const bool   slides =
          (now.time <= first) ?
                     way / first * now.time > mu * pressure * compliance :
                     moved > 2. * mu * pressure * compliance;
        if (slides)
          largest_error =
            std::max(largest_error,
                     std::abs(now.model.reaction(1)[0] -
                              (now.time <= first ? 1. : -1.) * mu * pressure));
      };
      ASSERT_EQ(s->run(), finished);
      EXPECT_LT(largest_error, 1e-3 * mu * pressure) << facets;
      // what the springs keep at the start, and give back on turning
      const double slip =
        way * (1. + 1. / 3.) - 3. * mu * pressure * compliance;
      EXPECT_NEAR(s->model.interfaces[0]->report().dissipation,
                  mu * pressure * slip,
                  5e-3 * mu * pressure * slip)
        << facets;
    }
}

INSTANTIATE_TEST_SUITE_P(Some, LongWay, testing::Values(60u));
INSTANTIATE_TEST_SUITE_P(All, LongWay, testing::Values(1000u));


// X18: a bar flies against a wall (c = 1, rho = 1, v = 1/100) with steps of a
// fifth of h/c to a hundred times that. It gains no energy, or says so; with
// steps up to a twentieth of the contact's time it leaves with the impulse it
// brought.
TEST(ExtremeMotion, ImpactsWithAnyStep)
{
  for (const double courant : {0.2, 1., 2., 4., 20., 100.})
    {
      const unsigned int n    = 40;
      const double       step = courant / n;
      Log                log(MPI_COMM_WORLD, true);
      auto               s =
        make<2>(names("bar", "", "end") +
                  body("bar",
                       "Lower corner = 0,0|Upper corner = 1,0.1|Cells = 40,1",
                       "Law = linear elastic|Young's modulus = 1|Poisson's "
                       "ratio = 0|Density = 1",
                       "Initial velocity = 0.01; 0") +
                  rigid("wall",
                        "Type = plane|Position = 1.001, 0|Axis = -1, 0") +
                  interface("end",
                            "Secondary = bar: boundary 1|Primary = wall|"
                            "Law = linear|Stiffness scale = 100") +
                  section("Dynamics", "Type = dynamic|Spectral radius = 0.8") +
                  solver(1e-10, step) + section("Steps", "End time = 4"),
                log);
      const double mass = 0.1, speed = 0.01;
      double       most = 0.;
      s->after_step     = [&](Simulation<2> &now) {
        most =
          std::max(most,
                   now.model.kinetic_energy() + now.model.strain_energy(now.u) +
                     now.model.interfaces[0]->report().energy);
      };
      ASSERT_EQ(s->run(), finished) << courant;
      const double v     = s->model.momentum()[0] / mass;
      const double start = 0.5 * mass * speed * speed;
      if (most > 1.05 * start)
        {
          // steps longer than the whole contact: said in words
          EXPECT_GT(step, 2.);
          std::ifstream     file(s->scene.output.directory + "/run.log");
          std::stringstream text;
          text << file.rdbuf();
          EXPECT_NE(text.str().find("more energy"), std::string::npos);
          continue;
        }
      EXPECT_LT(most, 1.01 * start) << courant;
      // the contact takes 2 L/c = 2
      if (step <= 2. / 20.)
        {
          EXPECT_NEAR(speed - v,
                      2. * speed,
                      (courant <= 2. ? 0.02 : 0.04) * 2. * speed)
            << courant;
        }
    }
}


namespace
{
  class Bounces : public testing::TestWithParam<unsigned int>
  {};
} // namespace


// X18: a bar between two springs, stiff enough that its own waves (2 L/c = 2)
// are short against a contact of pi sqrt(m/k). With a twentieth of that as step
// each impact returns the impulse 2 m v to 1 %, and changes the energy by less
// than 1 %, and so do as many as the parameter says.
TEST_P(Bounces, KeepEnergyAndImpulse)
{
  const double mass = 0.1, speed = 0.01, stiffness = 0.02;
  const double contact_time = numbers::PI * std::sqrt(mass / stiffness);
  // force = 0.1 K g/l times the area 0.1 of the end
  const auto springs = [&](const std::string &name,
                           const std::string &end,
                           const std::string &wall) {
    return interface(name,
                     "Secondary = bar: boundary " + end + "|Primary = " + wall +
                       "|Law = linear|Stiffness = " + num(50. * stiffness) +
                       "|Characteristic length = 0.5|Release = report");
  };
  Log  log(MPI_COMM_WORLD, true);
  auto s =
    make<2>(names("bar", "", "left, right") +
              body("bar",
                   "Lower corner = 0,0|Upper corner = 1,0.1|Cells = 10,1",
                   "Law = linear elastic|Young's modulus = 1|Poisson's ratio = "
                   "0|Density = 1",
                   "Initial velocity = 0.01; 0") +
              rigid("before", "Type = plane|Position = -0.001, 0|Axis = 1, 0") +
              rigid("behind", "Type = plane|Position = 1.001, 0|Axis = -1, 0") +
              section("Rigid bodies", "Names = before, behind") +
              springs("left", "0", "before") + springs("right", "1", "behind") +
              section("Dynamics", "Type = dynamic|Spectral radius = 1") +
              solver(1e-10, contact_time / 20.) +
              section("Steps",
                      "End time = " +
                        num((GetParam() + 0.5) * (contact_time + 0.2))),
            log);
  const double start  = 0.5 * mass * speed * speed;
  unsigned int n      = 0;
  double       before = mass * speed, fastest = 0., energy = start;
  double       worst_impulse = 0., worst_energy = 0., last_way = 1.;
  s->after_step = [&](Simulation<2> &now) {
    const double momentum = now.model.momentum()[0];
    if (momentum * last_way < 0.)
      {
        // turned: the flight between is the fastest
        if (n > 0)
          {
            worst_impulse =
              std::max(worst_impulse,
                       std::abs(before + fastest - 2. * mass * speed) /
                         (2. * mass * speed));
            before = fastest;
          }
        fastest                = 0.;
        last_way               = -last_way;
        const double energy_at = now.model.kinetic_energy() +
                                 now.model.strain_energy(now.u) +
                                 now.model.interfaces[0]->report().energy +
                                 now.model.interfaces[1]->report().energy;
        worst_energy = std::max(worst_energy, std::abs(energy_at - energy));
        energy       = energy_at;
        ++n;
      }
    fastest = std::max(fastest, std::abs(momentum));
  };
  ASSERT_EQ(s->run(), finished);
  EXPECT_GE(n, GetParam() - 3);
  EXPECT_LT(worst_impulse, 0.01);
  EXPECT_LT(worst_energy, 0.01 * start);
  EXPECT_NEAR(energy, start, 0.02 * start);
}

INSTANTIATE_TEST_SUITE_P(Some, Bounces, testing::Values(10u));
INSTANTIATE_TEST_SUITE_P(All, Bounces, testing::Values(100u));


namespace
{
  std::string
  resting(const std::string &friction)
  {
    return names("block", "push", "i") +
           body("block",
                "Lower corner = 0,0|Upper corner = 1,0.5|Cells = 4,2",
                "Law = linear elastic|Young's modulus = 1000",
                "Body force = 0; -2*t") +
           rigid("floor", "Type = plane") +
           condition(
             "push",
             "Body = block|Boundary ids = 0|Type = traction|x = 0.1*t") +
           interface(
             "i",
             "Secondary = block: boundary 2|Primary = floor|"
             "Law = linear|Stiffness = 1000|Characteristic length = 0.2|"
             "Secondary offset = 1e-3|Initial penetration = ignore|"
             "Initial pressure = 0.1" +
               friction) +
           solver(1e-10, 0.25);
  }
} // namespace


// X22: a block that only contact holds. Pushed along a floor without friction
// nothing holds it: said in words. With friction it is at rest.
TEST(ExtremeMotion, BlockHeldByContactOnly)
{
  {
    Log  log(MPI_COMM_WORLD, true);
    auto s =
      make<2>(resting("") + section("Steps", "Smallest step = 0.1"), log);
    EXPECT_EQ(s->run(), no_convergence);
    EXPECT_TRUE(std::isfinite(s->u.linfty_norm()));
    std::ifstream     file(s->scene.output.directory + "/run.log");
    std::stringstream text;
    text << file.rdbuf();
    EXPECT_NE(text.str().find("singular"), std::string::npos) << text.str();
  }
  const auto s = run<2>(resting("|Friction coefficient = 0.3"));
  EXPECT_NEAR(s->model.interfaces[0]->report().force[1], 1., 1e-8);
  EXPECT_NEAR(s->model.interfaces[0]->report().force[0], -0.05, 1e-8);
}


// X22: contact that is lost within a run, and comes again.
TEST(ExtremeMotion, ContactThatIsLostAndReturns)
{
  Log  log(MPI_COMM_WORLD, true);
  auto s = make<2>(
    names("block", "top", "i") +
      body("block",
           "Lower corner = 0,0|Upper corner = 1,1|Cells = 3,3",
           "Law = neo-Hookean|Young's modulus = 1000") +
      rigid("floor", "Type = plane") +
      condition("top",
                "Body = block|Boundary ids = 3|x = 0|y = -0.05*cos(2*pi*t)") +
      interface("i",
                "Secondary = block: boundary 2|Primary = floor|Stiffness "
                "scale = 10") +
      solver(1e-10, 0.05),
    log);
  std::vector<double> forces;
  s->after_step = [&](Simulation<2> &now) {
    forces.push_back(now.model.interfaces[0]->report().force[1]);
  };
  ASSERT_EQ(s->run(), finished);
  EXPECT_EQ(s->cut_backs, 0u);
  ASSERT_EQ(forces.size(), 20u);
  EXPECT_EQ(forces[9], 0.); // lifted by 0.05
  // elastic: as far down on the way back as on the way there
  for (unsigned int i = 0; i < 4; ++i)
    EXPECT_NEAR(forces[i], forces[18 - i], 1e-7 * forces[18]);
}


namespace
{
  /// A bar against a wall in steps of a size: growth of the energy as the run
  /// says.
  double
  energy_growth(const double step, const std::string &contact, const double end)
  {
    const auto s = run<2>(
      names("bar", "", "end") +
      body("bar",
           "Lower corner = 0,0|Upper corner = 1,0.1|Cells = 20,1",
           "Law = linear elastic|Young's modulus = 1|Poisson's ratio = "
           "0|Density = 1",
           "Initial velocity = 0.01; 0") +
      rigid("wall", "Type = plane|Position = 0.999, 0|Axis = -1, 0") +
      interface("end",
                "Secondary = bar: boundary 1|Primary = wall|Law = linear|"
                "Stiffness scale = 100|" +
                  contact) +
      section("Dynamics", "Type = dynamic|Spectral radius = 0.8") +
      solver(1e-10, step) + section("Steps", "End time = " + num(end)));
    std::ifstream file(s->scene.output.directory + "/summary.json");
    return nlohmann::json::parse(file).value("energy_growth", -1.);
  }
} // namespace


// In statics, what is put in is what is stored and dissipated, but for the
// trapezoidal rule of the work: a block pressed by 30 %, stored energy only,
// and one that slides with friction. Order 2 is the rule's.
TEST(ExtremeMotion, StaticEnergyErrorIsThatOfTheSteps)
{
  const auto error = [](const double step, const std::string &friction) {
    const auto s = run<2>(
      names("block", "top", "floor") +
      body("block",
           "Lower corner = 0,0|Upper corner = 1,1|Cells = 4,4",
           "Law = neo-Hookean|Young's modulus = 1000|Poisson's ratio = 0.3") +
      rigid("ground", "Type = plane") +
      condition("top",
                "Body = block|Boundary ids = 3|y = -0.3*t|x = " +
                  (friction.empty() ? std::string("0") :
                                      std::string("0.2*t"))) +
      interface("floor",
                "Secondary = block: boundary 2|Primary = ground|"
                "Law = linear|Stiffness scale = 100" +
                  friction) +
      solver(1e-10, step));
    std::ifstream file(s->scene.output.directory + "/summary.json");
    return nlohmann::json::parse(file).value("energy_error", -1.);
  };
  const double coarse = error(0.1, ""), fine = error(0.05, "");
  EXPECT_LT(coarse, 0.01);
  EXPECT_GT(coarse, 3. * fine);
  EXPECT_LT(error(0.05, "|Friction coefficient = 0.2"), 0.02);
}


// The audit of the energy: a run that conserves it is not accused, one step
// that is longer than the impact is, and where a treatment does work there is
// no verdict.
TEST(ExtremeMotion, EnergyOutOfNothingIsTold)
{
  EXPECT_LT(energy_growth(0.0125, "Release = report", 3.), 0.05);
  EXPECT_GT(energy_growth(1.5, "Release = report", 1.5), 0.05);
  EXPECT_EQ(
    energy_growth(0.05,
                  "Initial penetration = remove over time|Removal time = 1",
                  1.),
    -1.);
}
