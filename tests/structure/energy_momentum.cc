// SPDX-License-Identifier: LGPL-2.1-or-later

// The energy-momentum method: what a motion keeps.

#include "../support/run_scene.h"

#include <algorithm>
#include <cmath>

namespace
{
  using namespace Test;

  /// A strip of a shell that is thrown with given velocities.
  std::string
  thrown(const std::string &velocity,
         const std::string &method,
         const double       step,
         const double       end)
  {
    return names("strip", "", "") +
           body("strip",
                "Lower corner = -0.5, -0.15|Upper corner = 0.5, 0.15|"
                "Cells = 8, 3",
                "Young's modulus = 1e6|Poisson's ratio = 0.3|Density = 1",
                "Type = shell|Thickness = 0.01|Initial velocity = " +
                  velocity) +
           section("Dynamics", "Type = dynamic|" + method) +
           solver(1e-12, step) +
           section("Steps",
                   "End time = " + num(end) + "|Largest step = " + num(step) +
                     "|Smallest step = " + num(step));
  }

  /// It turns, bends and twists.
  const std::string widely = "1 - 12*y; 12*x; 8*x*y + 30*(x^2 - 0.08)";

  /// Places times masses times velocities, of mid-surface and directors.
  Tensor<1, 3>
  angular_momentum(Simulation<3> &s)
  {
    Tensor<1, 3>   sum;
    const Vector_t u = s.model.ghosted(s.u),
                   v = s.model.ghosted(s.model.integration.v_n);
    std::vector<types::global_dof_index> dofs;
    Vector<double>                       places, velocities, momenta;
    for (const auto &b : s.model.bodies)
      for (unsigned int cell = 0; cell < b->n_local_cells(); ++cell)
        {
          s.model.cell_values(*b, cell, u, places, dofs);
          s.model.cell_values(*b, cell, v, velocities, dofs);
          FullMatrix<double> mass(dofs.size(), dofs.size());
          b->mass(cell, mass);
          momenta.reinit(dofs.size());
          mass.vmult(momenta, velocities);
          for (unsigned int k = 0; k < dofs.size(); k += 3)
            {
              Tensor<1, 3> x, p;
              for (unsigned int i = 0; i < 3; ++i)
                {
                  x[i] = b->place_of(cell, k + i).arm[i] + places(k + i);
                  p[i] = momenta(k + i);
                }
              sum += cross_product_3d(x, p);
            }
        }
    return Utilities::MPI::sum(sum, MPI_COMM_WORLD);
  }

  struct Changes
  {
    double energy = 0., momentum = 0., angular = 0.; ///< Largest, relative.
    double strain = 0.; ///< Largest share of strain energy.
    bool   ended  = false;
  };

  Changes
  changes(const std::string &method, const double step, const double end)
  {
    Log          log(MPI_COMM_WORLD, true);
    const auto   s = make<3>(thrown(widely, method, step, end), log);
    Changes      result;
    const double energy   = s->model.kinetic_energy();
    const auto   momentum = s->model.momentum();
    const auto   angular  = angular_momentum(*s);
    s->after_step         = [&](Simulation<3> &now) {
      const double strain = now.model.strain_energy(now.u);
      const auto   most = [](double &a, const double b) { a = std::max(a, b); };
      most(result.energy,
           std::abs(now.model.kinetic_energy() + strain - energy) / energy);
      most(result.momentum,
           (now.model.momentum() - momentum).norm() / momentum.norm());
      most(result.angular,
           (angular_momentum(now) - angular).norm() / angular.norm());
      most(result.strain, strain / energy);
    };
    result.ended = s->run() == finished;
    return result;
  }
} // namespace


// Reference: Noether. The strip turns once in half a second; a wave crosses it
// in a thousandth, a tenth of a step.
TEST(EnergyMomentum, AThrownShellKeepsEnergyMomentumAndAngularMomentum)
{
  const auto kept =
    changes("Method = energy-momentum|Spectral radius = 1", 0.01, 2.);
  EXPECT_TRUE(kept.ended);
  EXPECT_GT(kept.strain, 0.1); // it deforms
  EXPECT_LT(kept.energy, 1e-9) << kept.energy;
  EXPECT_LT(kept.momentum, 1e-9);
  EXPECT_LT(kept.angular, 1e-9);

  // the average of the forces of both ends instead: nothing keeps the energy
  const auto averaged = changes("Spectral radius = 1", 0.01, 2.);
  EXPECT_GT(std::max(averaged.energy, averaged.ended ? 0. : 1.), 0.01);
}


// Second order: half the step, a quarter of the error. The strip turns in its
// plane and swings along itself, 20 steps in a period: in bending the directors
// would swing by themselves, unresolved.
TEST(EnergyMomentum, IsOfSecondOrder)
{
  const auto at = [](const unsigned int n) {
    const double end = 0.004;
    Log          log(MPI_COMM_WORLD, true);
    const auto   s =
      make<3>(thrown("10*sin(3.14159265*x) - 12*y; 12*x; 0",
                     "Method = energy-momentum|Spectral radius = 1",
                     end / n,
                     end),
              log);
    EXPECT_EQ(s->run(), finished);
    return s->u;
  };
  const Vector_t fine   = at(320);
  Vector_t       coarse = at(40), half = at(80);
  coarse -= fine;
  half -= fine;
  // (h^2 - (h/8)^2) / ((h/2)^2 - (h/8)^2); first order would be 7/3
  EXPECT_NEAR(coarse.l2_norm() / half.l2_norm(), 63. / 15., 0.6);
}
