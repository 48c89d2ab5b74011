// SPDX-License-Identifier: LGPL-2.1-or-later

// What a rank knows of a contact surface, and what it costs it: a plate of
// n x n facets sliding on another, distributed meshes of which a rank has its
// part. Build with -DMORTAR_CONTACT_BENCHMARKS=ON, run
//   mpirun -np RANKS build/ranks_benchmark [n: a power of two times 8]

#include <mortar_contact/mortar_contact.h>

#include <deal.II/base/function.h>
#include <deal.II/base/timer.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_fe.h>

#include <deal.II/grid/grid_generator.h>

#include <deal.II/lac/trilinos_vector.h>

#include <deal.II/numerics/vector_tools.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

using namespace dealii;
using namespace MortarContact;

namespace
{
  double
  megabytes()
  {
    Utilities::System::MemoryStats stats;
    Utilities::System::get_memory_stats(stats);
    return stats.VmRSS / 1024.;
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  const MPI_Comm                   communicator = MPI_COMM_WORLD;
  const unsigned int               n = (argc > 1) ? std::atoi(argv[1]) : 128;

  // two plates of 8 x 8 x 1 coarse cells
  Triangulation<3> lower, upper, coarse;
  GridGenerator::subdivided_hyper_rectangle(lower,
                                            {8, 8, 1},
                                            Point<3>(),
                                            Point<3>(8., 8., 1.));
  GridGenerator::subdivided_hyper_rectangle(upper,
                                            {8, 8, 1},
                                            Point<3>(0.013, 0.017, 0.999),
                                            Point<3>(8., 8., 2.));
  for (const auto &cell : upper.active_cell_iterators())
    cell->set_material_id(1);
  GridGenerator::merge_triangulations(lower, upper, coarse, 0.);
  for (const auto &cell : coarse.active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary() &&
          std::abs(cell->face(f)->center()[2] - 1.) < 0.1)
        cell->face(f)->set_boundary_id(10 + cell->material_id());
  parallel::distributed::Triangulation<3> mesh(communicator);
  mesh.copy_triangulation(coarse);
  for (unsigned int cells = 8; cells < n; cells *= 2)
    {
      // one layer of fine cells at the surfaces
      for (const auto &cell : mesh.active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary() &&
                cell->face(f)->boundary_id() >= 10)
              cell->set_refine_flag();
      mesh.execute_coarsening_and_refinement();
    }
  const FESystem<3>  fe(FE_Q<3>(1), 3);
  const MappingFE<3> mapping(FE_Q<3>(1));
  DoFHandler<3>      dof_handler(mesh);
  dof_handler.distribute_dofs(fe);
  TrilinosWrappers::MPI::Vector u(dof_handler.locally_owned_dofs(),
                                  communicator);

  const double        before = megabytes();
  Timer               timer(communicator, true);
  ContactInterface<3> contact("plates", {}, communicator);
  const auto          modulus = [](const auto &) { return 1000.; };
  contact.add_secondary(
    dof_handler, mapping, boundary_ids({10}), modulus, "lower");
  contact.add_primary(
    dof_handler, mapping, boundary_ids({11}), modulus, "upper");
  contact.setup();
  timer.stop();
  const double setup = timer.wall_time();
  // half a facet in each step
  timer.restart();
  for (unsigned int step = 1; step <= 4; ++step)
    {
      VectorTools::interpolate(mapping,
                               dof_handler,
                               FunctionFromFunctionObjects<3>(
                                 {[&](const Point<3> &x) {
                                    return x[2] > 0.9995 ? 4. * step / n : 0.;
                                  },
                                  [](const Point<3> &) { return 0.; },
                                  [](const Point<3> &) { return 0.; }}),
                               u);
      contact.update(u, step);
      contact.commit(step);
    }
  timer.stop();
  // cells, own facets, known facets, memory before contact and of it
  std::vector<double> values = {
    double(mesh.n_active_cells()), 0., 0., before, megabytes() - before};
  for (const unsigned int side : {0u, 1u})
    {
      values[1] += contact.surface(side).skin.n_own;
      values[2] += contact.surface(side).skin.facets.size();
    }
  std::vector<double> sums(values.size()), most(values.size());
  Utilities::MPI::sum(values, communicator, sums);
  Utilities::MPI::max(values, communicator, most);
  const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
  if (Utilities::MPI::this_mpi_process(communicator) == 0)
    std::printf("| %u | %.0f | %.0f / %.0f | %.0f / %.0f | %.0f / %.0f | "
                "%.0f / %.0f | %u | %.2f | %.2f |\n",
                n_ranks,
                sums[1],
                sums[0] / n_ranks,
                most[0],
                sums[2] / n_ranks,
                most[2],
                sums[3] / n_ranks,
                most[3],
                sums[4] / n_ranks,
                most[4],
                contact.report().active_pairs,
                setup,
                timer.wall_time());
}
