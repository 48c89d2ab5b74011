// SPDX-License-Identifier: LGPL-2.1-or-later

// Coulomb friction against closed forms (THEORY T22, T23, T25 to T28).

#include "../support/run_scene.h"

#include <cmath>

using namespace Test;

namespace
{
  // A block of one cell whose nodes are all held at the height -0.02: its
  // bottom is 0.02 deep in the floor, p = 100 (0.02/0.2 - 0.03) = 7, and the
  // only freedom is simple shear: compliance h/G = 1/400 in series with that of
  // the contact, 1/E_T = 0.2/(0.1 1000) = 1/500.
  const double pressure = 7., onset = 1. / 400. + 1. / 500.;

  const std::string elastic =
    "Law = linear elastic|Young's modulus = 1000|Poisson's ratio = 0.25";
  const std::string stiffness =
    "|Stiffness = 1000|Characteristic length = 0.2|"
    "Kind = forming surface to surface|Release = report";

  std::string
  sheared_block(const std::string &x,
                const std::string &contact,
                const double       step)
  {
    return names("block", "down, top", "i") +
           body("block",
                "Lower corner = 0,0|Upper corner = 1,1|Cells = 1,1",
                elastic) +
           rigid("floor", "Type = plane") +
           condition("down", "Body = block|Boundary ids = 0,1,2,3|y = -0.02") +
           condition("top", "Body = block|Boundary ids = 3|x = " + x) +
           interface("i",
                     "Secondary = block: boundary 2|Primary = floor" +
                       stiffness + contact) +
           solver(1e-12, step);
  }
} // namespace


TEST(Friction, StickingBlockIsHeldByTheTangentialStiffness)
{
  const auto s =
    run<2>(sheared_block("0.005*t", "|Friction coefficient = 0.3", 0.25));
  EXPECT_NEAR(s->model.reaction(1)[0], 0.005 / onset, 1e-10);
  EXPECT_EQ(s->model.interfaces[0]->report().slip_area, 0.);
  EXPECT_EQ(s->model.interfaces[0]->report().dissipation, 0.);
}


TEST(Friction, SlidingBlockIsHeldByMuTimesTheNormalForce)
{
  const auto s =
    run<2>(sheared_block("0.05*t", "|Friction coefficient = 0.3", 0.25));
  EXPECT_NEAR(s->model.reaction(1)[0], 0.3 * pressure, 1e-10);
  EXPECT_NEAR(s->model.interfaces[0]->report().slip_area, 1., 1e-12);
  EXPECT_NEAR(s->model.interfaces[0]->report().dissipation,
              0.3 * pressure * (0.05 - 0.3 * pressure * onset),
              1e-10);
  EXPECT_LE(s->newton_iterations, 3u * s->step);
}


TEST(Friction, ElasticSlipMayBeGiven)
{
  // |tau| = mu p g/s up to g = s
  const auto s = run<2>(sheared_block(
    "0.05*t", "|Friction coefficient = 0.3|Elastic slip = 1e-4", 0.25));
  EXPECT_NEAR(s->model.reaction(1)[0], 0.3 * pressure, 1e-10);
  EXPECT_NEAR(s->model.interfaces[0]->report().dissipation,
              0.3 * pressure * (0.05 - 0.3 * pressure / 400. - 1e-4),
              1e-10);
}


TEST(Friction, CoefficientFollowsTheSlipRate)
{
  // FD + (FS - FD) exp(-DC v): in the end the block slides as fast as its top
  // moves, 0.05
  const auto s = run<2>(
    sheared_block("0.05*t",
                  "|Friction coefficient = 0.4|Dynamic friction coefficient = "
                  "0.1|Friction decay = 10",
                  0.25) +
    section("Steps", "End time = 5"));
  EXPECT_NEAR(s->model.reaction(1)[0],
              pressure * (0.1 + 0.3 * std::exp(-0.5)),
              1e-8);
  const auto f =
    run<2>(sheared_block("0.05*t", "|Friction function = 0.5/(1+p/7)+v", 0.25) +
           section("Steps", "End time = 5"));
  EXPECT_NEAR(f->model.reaction(1)[0], pressure * (0.25 + 0.05), 1e-8);
}


// THEORY T25
TEST(Friction, CyclesDissipateWhatTheirAreaSays)
{
  const double U = 0.02;
  Log          log(MPI_COMM_WORLD, true);
  auto         s =
    make<2>(sheared_block("0.02*if(t<1, t, if(t<3, 2-t, t-4))",
                          "|Friction coefficient = 0.3",
                          0.1) +
              section("Steps",
                      "End time = 5|First step = 0.1|Times to meet = 1,3"),
            log);
  double last   = 0.;
  s->after_step = [&](Simulation<2> &now) {
    const double d = now.model.interfaces[0]->report().dissipation;
    EXPECT_GE(d, last);
    last = d;
  };
  EXPECT_EQ(s->run(), finished);
  EXPECT_NEAR(last, 5. * 0.3 * pressure * (U - 0.3 * pressure * onset), 1e-8);
}


// THEORY T26
TEST(Friction, TractionFollowsTheLastLegOfASquarePathAndNoDirectionIsSpecial)
{
  Tensor<1, 3> first;
  for (const double angle : {0., 0.65})
    {
      const double       c = std::cos(angle), q = std::sin(angle);
      std::ostringstream x, y;
      x.precision(17);
      y.precision(17);
      const std::string u = "(if(t<1, t, if(t<2, 1, 3-t)))",
                        v = "(if(t<1, 0, if(t<2, t-1, 1)))";
      x << "0.2*(" << c << "*" << u << "-" << q << "*" << v << ")";
      y << "0.2*(" << q << "*" << u << "+" << c << "*" << v << ")";
      const auto s = run<3>(
        names("block", "down, top", "i") +
        body("block",
             "Lower corner = 0,0,0|Upper corner = 1,1,1|Cells = 1,1,1",
             elastic) +
        rigid("floor", "Type = plane") +
        condition("down", "Body = block|Boundary ids = 0,1,2,3,4,5|z = -0.02") +
        condition("top",
                  "Body = block|Boundary ids = 5|x = " + x.str() +
                    "|y = " + y.str()) +
        interface("i",
                  "Secondary = block: boundary 4|Primary = floor|Friction "
                  "coefficient = 0.3" +
                    stiffness) +
        solver(1e-12, 0.05) +
        section("Steps", "End time = 3|Times to meet = 1,2"));
      const Tensor<1, 3> F = s->model.reaction(1);
      EXPECT_NEAR(std::hypot(F[0], F[1]), 0.3 * pressure, 1e-8);
      // the last leg goes along -x, turned
      EXPECT_NEAR(F[0], -0.3 * pressure * c, 1e-5);
      EXPECT_NEAR(F[1], -0.3 * pressure * q, 1e-5);
      const Tensor<1, 3> back({c * F[0] + q * F[1], c * F[1] - q * F[0], F[2]});
      if (angle == 0.)
        first = back;
      else
        EXPECT_LT((back - first).norm(), 1e-10 * first.norm());
    }
}


// THEORY T27: soft tangential springs drag a sticking block over the edges of
// the floor's facets: the traction grows linearly all the way.
TEST(Friction, StickCrossesOpposingEdgesWithoutAJump)
{
  Log  log(MPI_COMM_WORLD, true);
  auto s = make<2>(
    names("block, ground", "down, top, fixed", "i") +
      body("block",
           "Lower corner = 0,0|Upper corner = 1,1|Cells = 1,1",
           elastic) +
      body("ground",
           "Lower corner = -0.3,-1|Upper corner = 2.3,0|Cells = 19,1",
           elastic) +
      condition("down", "Body = block|Boundary ids = 0,1,2,3|y = -0.02") +
      condition("top", "Body = block|Boundary ids = 3|x = 0.5*t") +
      condition("fixed", "Body = ground|Boundary ids = 0,1,2,3|x = 0|y = 0") +
      interface("i",
                "Secondary = block: boundary 2|Primary = ground: boundary 3|"
                "Friction coefficient = 1e6" +
                  stiffness) +
      solver(1e-12, 0.04),
    log);
  s->after_step = [&](Simulation<2> &now) {
    EXPECT_NEAR(now.model.reaction(1)[0],
                0.5 * now.time / onset,
                1e-6 * 0.5 / onset);
  };
  EXPECT_EQ(s->run(), finished);
}


// THEORY T28
TEST(Friction, BlockStartsToSlideAtTheAngleOfFriction)
{
  Log  log(MPI_COMM_WORLD, true);
  auto s = make<2>(
    names("block", "top", "i") +
      body("block",
           "Lower corner = 0,0|Upper corner = 4,0.5|Cells = 16,2",
           elastic) +
      rigid("floor", "Type = plane") +
      condition("top",
                "Body = block|Boundary ids = 3|Type = traction|x = t|y = -1") +
      interface(
        "i",
        "Secondary = block: boundary 2|Primary = floor|Friction "
        "coefficient = 0.3|Law = linear|Secondary offset = 1e-3|Initial "
        "penetration = ignore|Initial pressure = 1" +
          stiffness) +
      solver(1e-9, 0.02) +
      section("Steps", "Smallest step = 2e-4|Largest step = 0.02"),
    log);
  EXPECT_EQ(s->run(), no_convergence);
  EXPECT_NEAR(std::atan(s->time), std::atan(0.3), 1e-3);
}
