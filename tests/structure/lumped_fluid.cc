// SPDX-License-Identifier: LGPL-2.1-or-later

// The lumped fluid of a valve, alone and around a plate.

#include "../support/run_scene.h"

#include <array>
#include <cmath>
#include <random>
#include <structure/lumped_fluid.h>

namespace
{
  using namespace Test;

  FluidParameters
  fluid_parameters()
  {
    FluidParameters p;
    p.density               = 1.06;
    p.inlet_resistance      = 5.;
    p.inlet_inertance       = 0.6;
    p.sinus_resistance      = 7.;
    p.sinus_inertance       = 1.1;
    p.leak                  = 1e-3;
    p.closed_area           = 0.1;
    p.aortic_impedance      = 60.;
    p.peripheral_resistance = 1250.;
    p.compliance            = 1.2e-3;
    p.venous_pressure       = 4e3;
    p.aortic_pressure       = 1.07e5;
    return p;
  }

  double
  ventricle(const double t)
  {
    return 1e5 + 6e4 * std::sin(20. * t);
  }

  /// A valve that does not move, with steps of the same size.
  LumpedFluid::State
  rigid_valve(const LumpedFluid &fluid,
              const double       area,
              const double       end,
              const unsigned int n)
  {
    LumpedFluid::State state = fluid.at_rest(ventricle(0.));
    LumpedFluid::Loads loads;
    for (unsigned int k = 1; k <= n; ++k)
      state = fluid.step(
        state, end / n, ventricle(k * end / n), {0., 0.}, area, loads);
    return state;
  }
} // namespace


// Reference: the same two ordinary differential equations by the classical
// Runge-Kutta method, with the flow turning round within the interval.
TEST(LumpedFluid, AValveThatDoesNotMoveIsAnOrificeBeforeAWindkessel)
{
  const FluidParameters p    = fluid_parameters();
  const double          tube = 3.8, area = 1.3, end = 0.4;
  const LumpedFluid     fluid(p, tube, 2, 1.);

  const double inertance =
    p.inlet_inertance + p.density * std::sqrt(tube) / area;
  using Pair       = std::array<double, 2>; // Q, p_C
  const auto rates = [&](const double t, const Pair &x) {
    const double Q = x[0], p_C = x[1];
    const double loss =
      Q > 0. ? std::pow(1. / area - 1. / tube, 2) : std::pow(1. / area, 2);
    return Pair{{(ventricle(t) - p.inlet_resistance * Q -
                  0.5 * p.density * loss * Q * std::abs(Q) -
                  p.aortic_impedance * Q - p_C) /
                   inertance,
                 (Q - (p_C - p.venous_pressure) / p.peripheral_resistance) /
                   p.compliance}};
  };
  Pair               x = {{0., p.aortic_pressure}};
  const unsigned int n = 200000;
  const double       h = end / n;
  const auto shifted   = [](const Pair &a, const double by, const Pair &b) {
    return Pair{{a[0] + by * b[0], a[1] + by * b[1]}};
  };
  bool turned = false;
  for (unsigned int k = 0; k < n; ++k)
    {
      const double t  = k * h;
      const Pair   k1 = rates(t, x);
      const Pair   k2 = rates(t + 0.5 * h, shifted(x, 0.5 * h, k1));
      const Pair   k3 = rates(t + 0.5 * h, shifted(x, 0.5 * h, k2));
      const Pair   k4 = rates(t + h, shifted(x, h, k3));
      for (unsigned int i = 0; i < 2; ++i)
        x[i] += h / 6. * (k1[i] + 2. * k2[i] + 2. * k3[i] + k4[i]);
      turned = turned || x[0] < 0.;
    }
  EXPECT_TRUE(turned);

  // backward Euler is of first order: extrapolated
  const auto coarse = rigid_valve(fluid, area, end, 40000);
  const auto fine   = rigid_valve(fluid, area, end, 80000);
  EXPECT_NEAR(2. * fine.jet - coarse.jet, x[0], 1e-6 * std::abs(x[0]));
  EXPECT_NEAR(2. * fine.compliance - coarse.compliance, x[1], 1e-6 * x[1]);
  EXPECT_NEAR((coarse.jet - x[0]) / (fine.jet - x[0]), 2., 0.01);
  EXPECT_EQ(fine.jet, fine.inlet);
}


// Reference: p_V - p_ven = (R_i + Z + R) Q + rho/2 (1/A - 1/A_A)^2 Q^2.
TEST(LumpedFluid, SteadyFlowIsAQuadratic)
{
  const FluidParameters p = fluid_parameters();
  const LumpedFluid     fluid(p, 3.8, 3, 1.);
  LumpedFluid::State    state = fluid.at_rest(2e5);
  LumpedFluid::Loads    loads;
  for (unsigned int k = 0; k < 2000; ++k)
    state = fluid.step(state, 0.1, 2e5, {0., 0., 0.}, 0.9, loads);
  const double R =
    p.inlet_resistance + p.aortic_impedance + p.peripheral_resistance;
  const double B = 0.5 * p.density * std::pow(1. / 0.9 - 1. / 3.8, 2);
  const double Q =
    (std::sqrt(R * R + 4. * B * (2e5 - p.venous_pressure)) - R) / (2. * B);
  EXPECT_NEAR(state.jet, Q, 1e-10 * Q);
  // pressures in the sinuses are the aorta's, nothing moves there
  for (unsigned int i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(state.sinuses[i], state.aorta, 1e-6);
      EXPECT_NEAR(loads.values[i], state.aorta - state.lumen, 1e-6);
    }
}


TEST(LumpedFluid, DerivativesOfTheLoadsAgreeWithDifferences)
{
  const LumpedFluid  fluid(fluid_parameters(), 3.8, 2, 1.5);
  LumpedFluid::State before = fluid.at_rest(1e5);
  before.jet                = 30.;
  before.inlet              = 25.;
  before.swept              = {3., -2.};
  for (const double ventricle : {4e4, 2.5e5}) // backward, forward
    {
      const std::vector<double> swept = {4., -6.};
      const double              area = 0.8, dt = 2e-3;
      LumpedFluid::Loads        loads, plus, minus;
      const auto state = fluid.step(before, dt, ventricle, swept, area, loads);
      EXPECT_EQ(state.jet > 0., ventricle > 1e5);
      // nothing is lost: the aorta gets what the ventricle gives
      EXPECT_NEAR(state.inlet, state.jet - 1.5 * (4. - 6.), 1e-12);
      for (unsigned int j = 0; j < 3; ++j)
        {
          const double h  = 1e-5;
          const auto   at = [&](const double by, LumpedFluid::Loads &result) {
            auto   q = swept;
            double A = area;
            (j < 2 ? q[j] : A) += by;
            (void)fluid.step(before, dt, ventricle, q, A, result);
          };
          at(h, plus);
          at(-h, minus);
          for (unsigned int i = 0; i < 2; ++i)
            {
              const double difference =
                (plus.values[i] - minus.values[i]) / (2. * h);
              EXPECT_NEAR(j < 2 ? loads.by_swept(i, j) : loads.by_area[i],
                          difference,
                          1e-6 * std::abs(difference) + 1e-4);
            }
        }
    }
  // the orifice: never less than the leak, what is open otherwise
  double slope = 0.;
  EXPECT_NEAR(fluid.orifice(-10., slope), fluid.leak, 1e-6);
  EXPECT_NEAR(fluid.orifice(2., slope), 1.9 + fluid.leak, 1e-5);
  EXPECT_NEAR(slope, 1., 1e-5);
}


namespace
{
  /// A square plate, clamped or with one free edge (boundary id 1), with a
  /// sinus on its top.
  std::unique_ptr<Simulation<3>>
  plate(const std::string &more, const ValveParameters &valve, Log &log)
  {
    const auto *info = testing::UnitTest::GetInstance()->current_test_info();
    const std::string file = std::string("scene-") + info->name() + ".prm";
    std::ofstream(file) << "set Dimension = 3\n"
                        << body("plate",
                                "Lower corner = -0.5, -0.5|Upper corner = 0.5, "
                                "0.5|Cells = 6, 6",
                                "Young's modulus = "
                                "1e6|Poisson's ratio = 0.3|Density = 1e-3",
                                "Type = shell|Thickness = 0.02")
                        << more << "subsection Output\nset Directory = output-"
                        << info->name()
                        << "\nset Every = 0\nset Checkpoint every = 0\nend\n";
    SceneSource source;
    source.file   = file;
    source.driver = "contact_scene";
    std::string used;
    Scene       scene = read_scene(source, used);
    scene.valve       = valve;
    auto simulation =
      std::make_unique<Simulation<3>>(scene, used, MPI_COMM_WORLD, log);
    simulation->setup();
    return simulation;
  }

  const std::string dynamic =
    section("Dynamics", "Type = dynamic|Spectral radius = 0");

  ValveParameters
  valve_parameters()
  {
    ValveParameters valve;
    valve.is_on           = true;
    valve.body            = "plate";
    valve.tube_area       = 2.;
    valve.fluid           = fluid_parameters();
    valve.fluid.ventricle = "1e5 + 500*sin(300*t)";
    return valve;
  }
} // namespace


// Reference: differences of the residual. The tangent is the matrix and what
// the fluid adds to it.
TEST(ValveFluid, TangentAgreesWithDifferences)
{
  Log        log(MPI_COMM_WORLD, true);
  const auto s =
    plate(names("plate", "clamp", "") +
            condition("clamp",
                      "Body = plate|Boundary ids = 0|x = 0|y = 0|z = "
                      "0|Directors = fixed") +
            dynamic,
          valve_parameters(),
          log);
  Model<3> &model = s->model;
  model.integration.start_step(1e-3);
  std::mt19937                           random(2);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  Vector_t u = model.make_vector(), v = model.make_vector();
  for (const auto i : model.owned_dofs())
    {
      u(i) = 1e-3 * uniform(random);
      v(i) = uniform(random);
    }
  (void)model.assemble(u, 1e-3, true);
  model.constraints.set_zero(v);
  Vector_t exact = model.make_vector();
  model.matrix.vmult(exact, v);
  ASSERT_EQ(model.fluid->columns.size(), 1u);
  const double product = model.fluid->rows[0] * v;
  exact.add(-product, model.fluid->columns[0]);
  // it matters
  EXPECT_GT(std::abs(product) * model.fluid->columns[0].l2_norm(),
            1e-3 * exact.l2_norm());
  const double h          = 1e-7;
  Vector_t     difference = model.make_vector();
  for (const double sign : {-1., 1.})
    {
      Vector_t w = u;
      w.add(sign * h, v);
      (void)model.assemble(w, 1e-3, false);
      difference.add(-sign / (2. * h), model.rhs);
    }
  model.constraints.set_zero(difference);
  model.constraints.set_zero(exact);
  difference -= exact;
  EXPECT_LT(difference.l2_norm(), 1e-6 * exact.l2_norm());
}


// Reference: omega^2 = k (L_i + L_s)^-1, k the pressure per volume of the plate
// (of its own static solution). The plate has next to no mass, the blood is all
// that moves: this is where codes that solve in turns do not converge.
TEST(ValveFluid, APlateOfNoMassOscillatesWithTheBloodBehindAndBefore)
{
  const std::string clamp =
    condition("clamp",
              "Body = plate|Boundary ids = 0, 1, 2, 3|x = 0|y = 0|z = "
              "0|Directors = fixed");
  ValveParameters valve        = valve_parameters();
  valve.fluid.inlet_resistance = valve.fluid.sinus_resistance = 0.;
  valve.fluid.aortic_impedance                                = 0.;
  valve.fluid.compliance            = 1e6; // keeps its pressure
  valve.fluid.peripheral_resistance = 1e12;
  valve.fluid.venous_pressure       = 1e5;
  valve.fluid.aortic_pressure       = 1e5;
  valve.fluid.closed_area           = 10.;
  valve.fluid.leak                  = 1e-8;
  valve.fluid.jet_length            = 1e3; // no jet through the leak
  valve.fluid.ventricle             = "1e5 + 0.01";

  // Step 1: the plate's stiffness.
  double stiffness = 0.;
  {
    Log        log(MPI_COMM_WORLD, true);
    const auto s = plate(
      names("plate", "clamp, load", "") + clamp +
        condition("load",
                  "Body = plate|Type = pressure|On surface = true|Pressure = "
                  "0.01") +
        solver(),
      {},
      log);
    EXPECT_EQ(s->run(), finished);
    // the volume: work of a unit pressure
    double                               volume = 0.;
    std::vector<types::global_dof_index> dofs;
    Load<3>                              unit;
    unit.type       = Load<3>::Type::pressure;
    unit.on_surface = true;
    unit.formulas.emplace_back("1", "");
    unit.of_component = {{0, -1, -1}};
    Body<3> &b        = *s->model.bodies[0];
    for (unsigned int cell = 0; cell < b.n_local_cells(); ++cell)
      {
        Vector<double>     values, forces(b.n_dofs_per_cell(0));
        FullMatrix<double> none;
        s->model.cell_values(b, cell, s->model.ghosted(s->u), values, dofs);
        Vector<double> flat(values.size());
        b.add_load(cell, unit, flat, 0., forces, none);
        volume += forces * values;
      }
    stiffness = 0.01 / Utilities::MPI::sum(volume, MPI_COMM_WORLD);
  }

  // Step 2: times at which the volume passes its mean, after the first period.
  const double omega = std::sqrt(
    stiffness / (valve.fluid.inlet_inertance + valve.fluid.sinus_inertance));
  const double       period = 2. * numbers::PI / omega;
  std::ostringstream steps;
  steps.precision(15);
  steps << "subsection Steps\nset End time = " << 2.5 * period
        << "\nset First step = " << period / 200. << "\nend\n";
  Log        log(MPI_COMM_WORLD, true);
  const auto s =
    plate(names("plate", "clamp", "") + clamp + dynamic + steps.str(),
          valve,
          log);
  std::vector<double> passes;
  double              last_time = 0., last = 0.;
  s->after_step = [&](Simulation<3> &now) {
    const double volume = now.model.fluid->history().back() * stiffness + 0.01;
    if (last * volume < 0.)
      passes.push_back(last_time +
                       (now.time - last_time) * last / (last - volume));
    last      = volume;
    last_time = now.time;
  };
  EXPECT_EQ(s->run(), finished);
  ASSERT_GE(passes.size(), 4u);
  EXPECT_NEAR((passes[3] - passes[1]) / period, 1., 2e-3);
}


namespace
{
  /// A plate with closed ports after a push.
  struct ClosedPorts
  {
    double on_plate  = 0.; ///< Work of push and blood on the plate,
    double energy    = 0.; ///< its kinetic and strain energy at the end.
    double on_blood  = 0.; ///< Work of the plate on the blood, p dV,
    double kinetic   = 0.; ///< its energy at the end,
    double lost      = 0.; ///< and what the flow lost: by resistance and jet,
    double damped    = 0.; ///< and by Euler's method, L (Q - Q_n)^2/2.
    double flowed_in = 0.; ///< Through the inlet, largest sum.
    double volume    = 0.; ///< Under the plate, largest.
    double gap       = 0.; ///< Between that and what the blood counts.
  };

  /// Volume between the plane z = 0 and bilinear faces, whose rim lies in it:
  /// of cones; the mean of those below both triangulations.
  double
  volume_below(const Simulation<3> &s)
  {
    const Vector_t                       u = s.model.ghosted(s.u);
    Vector<double>                       values;
    std::vector<types::global_dof_index> dofs;
    const Body<3>                       &b      = *s.model.bodies[0];
    double                               volume = 0.;
    for (unsigned int cell = 0; cell < b.n_local_cells(); ++cell)
      {
        s.model.cell_values(b, cell, u, values, dofs);
        std::array<Tensor<1, 3>, 4> x;
        for (unsigned int v = 0; v < 4; ++v)
          for (unsigned int i = 0; i < 3; ++i)
            x[v][i] = b.place_of(cell, 6 * v).x[i] + values(6 * v + i);
        for (const auto &[i, j, k] : {std::array<unsigned int, 3>{{0, 1, 3}},
                                      {{0, 3, 2}},
                                      {{0, 1, 2}},
                                      {{1, 3, 2}}})
          volume += x[i] * cross_product_3d(x[j], x[k]) / 12.;
      }
    return Utilities::MPI::sum(volume, MPI_COMM_WORLD);
  }

  ClosedPorts
  push(const double step)
  {
    ValveParameters  valve = valve_parameters();
    FluidParameters &f     = valve.fluid;
    f.inlet_resistance     = 1e12;
    f.inlet_inertance      = 0.;
    f.aortic_pressure = f.venous_pressure = 0.;
    f.ventricle                           = "0";
    f.closed_area                         = 10.;
    f.leak                                = 0.02;
    f.sinus_inertance                     = 1e-3;
    f.sinus_resistance                    = 1e-2;
    f.density                             = 1e-4;
    // the plate has no free edge: the orifice is always the same
    double       slope = 0.;
    const double area =
      LumpedFluid(f, valve.tube_area, 1, 1.).orifice(0., slope);
    const double L =
      f.density * std::sqrt(valve.tube_area) / area + f.sinus_inertance;

    Log        log(MPI_COMM_WORLD, true);
    const auto s = plate(
      names("plate", "clamp, push", "") +
        condition("clamp",
                  "Body = plate|Boundary ids = 0, 1, 2, 3|x = 0|y = 0|z = 0") +
        condition("push",
                  "Body = plate|Type = traction|On surface = true|x = 0|y = "
                  "0|z = if(t < 0.005, 100*sin(628.3185307*t)^2, 0)") +
        section("Dynamics",
                "Type = dynamic|Method = energy-momentum|Spectral radius = 1") +
        solver(1e-12, step) +
        section("Steps",
                "End time = 0.01|Largest step = " + num(step) +
                  "|Smallest step = " + num(step)),
      valve,
      log);

    ClosedPorts result;
    Vector_t    before = s->model.make_vector(), forces = before;
    double      last_time = 0., jet = 0., flowed = 0.;
    s->after_step = [&](Simulation<3> &now) {
      const auto  &blood = now.model.fluid->state();
      const double dt    = now.time - last_time;
      last_time          = now.time;
      // forces are averaged over a step
      const Vector_t outer = now.model.outer_forces();
      forces += outer;
      Vector_t motion = now.u;
      motion -= before;
      result.on_plate += 0.5 * (forces * motion);
      before         = now.u;
      forces         = outer;
      const double p = blood.lumen - blood.sinuses[0], Q = blood.jet;
      const double B = 0.5 * f.density *
                       (Q > 0. ? std::pow(1. / area - 1. / valve.tube_area, 2) :
                                 std::pow(1. / area, 2));
      result.on_blood += dt * p * blood.swept[0];
      result.lost += dt * (B * std::abs(Q) + f.sinus_resistance) * Q * Q;
      result.damped += 0.5 * L * (Q - jet) * (Q - jet);
      jet = Q;
      flowed += dt * blood.inlet;
      result.flowed_in = std::max(result.flowed_in, std::abs(flowed));
      // the sinus lies on the top, and loses what the plate gains below
      const double volume = volume_below(now);
      result.volume       = std::max(result.volume, std::abs(volume));
      result.gap =
        std::max(result.gap,
                 std::abs(now.model.fluid->history().back() + volume));
    };
    EXPECT_EQ(s->run(), finished);
    result.energy  = s->model.kinetic_energy() + s->model.strain_energy(s->u);
    result.kinetic = 0.5 * L * jet * jet;
    return result;
  }
} // namespace


// V3 of the valve: with its ports closed blood only goes round the plate, which
// is deflected by a tenth of its width in steps of a hundredth.
TEST(ValveFluid, ClosedPortsKeepVolumesAndEnergy)
{
  const ClosedPorts whole = push(1e-4), half = push(5e-5);
  for (const ClosedPorts &c : {whole, half})
    {
      // the volume that is counted is the one below the present shape
      EXPECT_GT(c.volume, 0.02);
      EXPECT_LT(c.gap, 1e-13 * c.volume);
      EXPECT_LT(c.flowed_in, 1e-10 * c.volume);
      // of the plate, and of the blood: p dV = dE + losses
      EXPECT_NEAR(c.energy, c.on_plate, 1e-9 * c.on_blood);
      EXPECT_NEAR(c.kinetic + c.lost + c.damped, c.on_blood, 1e-9 * c.on_blood);
      EXPECT_GT(c.lost, 0.1 * c.on_blood);
    }
  // what Euler's method takes goes with the step
  EXPECT_LT(half.damped, 0.7 * whole.damped);
}
