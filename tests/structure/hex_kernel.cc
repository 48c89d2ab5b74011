// SPDX-License-Identifier: LGPL-2.1-or-later

// The kernel for eight hexahedra at once against the element, which is written
// in material form with a fourth-order tensor.

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <structure/hex_kernel.h>
#include <structure/solid_body.h>

namespace
{
  using namespace dealii;
  using namespace Structure;

  std::unique_ptr<SolidBody<3>>
  distorted_block(const MaterialParameters &parameters, const bool mean)
  {
    Triangulation<3> mesh;
    GridGenerator::subdivided_hyper_cube(mesh, 2);
    GridTools::distort_random(0.2, mesh, false);
    auto body = std::make_unique<SolidBody<3>>(
      "block", mesh, parameters.make(), 1, mean, false, MPI_COMM_SELF);
    body->numbering = MortarContact::DoFNumbering({0}, {0});
    return body;
  }
} // namespace


TEST(HexKernel, EqualsTheElement)
{
  for (const bool mean : {false, true})
    {
      MaterialParameters parameters;
      parameters.law            = mean ? "Mooney-Rivlin" : "neo-Hookean";
      parameters.youngs_modulus = 3.;
      parameters.poissons_ratio = 0.49;
      const auto body           = distorted_block(parameters, mean);
      ASSERT_EQ(body->n_local_cells(), HexKernel::width);

      HexKernel kernel;
      kernel.mu           = body->material->shear_modulus;
      kernel.bulk         = body->material->bulk_modulus;
      kernel.has_pressure = mean;

      std::mt19937                           random(7);
      std::uniform_real_distribution<double> by(-0.08, 0.08);
      HexKernel::Cells                       cells;
      std::vector<Vector<double>>            u(8, Vector<double>(24));
      for (unsigned int c = 0; c < 8; ++c)
        for (unsigned int a = 0; a < 8; ++a)
          for (unsigned int i = 0; i < 3; ++i)
            {
              u[c](3 * a + i)  = by(random);
              cells.u[a][i][c] = u[c](3 * a + i);
              cells.X[a][i][c] = body->vertex_of(c, a)[i];
            }
      HexKernel::Result result, forces_only, stored;
      kernel.evaluate(cells, false, true, result);
      kernel.evaluate(cells, false, false, forces_only);
      cells.pressure = result.pressure;
      kernel.evaluate(cells, true, true, stored);

      for (unsigned int c = 0; c < 8; ++c)
        {
          Vector<double>     forces(24);
          FullMatrix<double> tangent(24, 24);
          ASSERT_TRUE(body->evaluate(c, u[c], nullptr, true, forces, tangent));
          const double f      = forces.linfty_norm();
          const double k      = tangent.linfty_norm();
          const double along  = mean ? kernel.bulk / result.volume[c] : 0.;
          const double energy = body->energy(c, u[c]);
          EXPECT_GT(energy, 0.);
          EXPECT_NEAR(forces_only.energy[c], energy, 1e-12 * energy);
          for (unsigned int a = 0, ab = 0; a < 8; ++a)
            for (unsigned int b = a; b < 8; ++b, ++ab)
              for (unsigned int i = 0; i < 3; ++i)
                {
                  EXPECT_NEAR(result.forces[a][i][c],
                              forces(3 * a + i),
                              1e-13 * f);
                  EXPECT_NEAR(forces_only.forces[a][i][c],
                              forces(3 * a + i),
                              1e-13 * f);
                  EXPECT_NEAR(stored.forces[a][i][c],
                              forces(3 * a + i),
                              1e-13 * f);
                  for (unsigned int j = 0; j < 3; ++j)
                    EXPECT_NEAR(result.tangent[ab][i][j][c] +
                                  along * result.dv[a][i][c] *
                                    result.dv[b][j][c],
                                tangent(3 * a + i, 3 * b + j),
                                1e-13 * k);
                }
        }
    }
}


TEST(HexKernel, TellsCellsThatAreInsideOut)
{
  HexKernel kernel;
  kernel.mu = 1.;
  HexKernel::Cells cells;
  for (unsigned int a = 0; a < 8; ++a)
    for (unsigned int i = 0; i < 3; ++i)
      {
        const double x = (a >> i) & 1u;
        for (unsigned int c = 0; c < 8; ++c)
          {
            cells.X[a][i][c] = x;
            // the sixth cell is pushed through itself
            cells.u[a][i][c] = (c == 5 && i == 0) ? -1.5 * x : 0.;
          }
      }
  HexKernel::Result result;
  kernel.evaluate(cells, false, false, result);
  for (unsigned int c = 0; c < 8; ++c)
    EXPECT_EQ(result.smallest_J[c] > 0., c != 5);
  cells.u[0][0][2] = std::nan("");
  kernel.evaluate(cells, false, false, result);
  EXPECT_FALSE(result.smallest_J[2] > 0.);
}
