// SPDX-License-Identifier: LGPL-2.1-or-later

// The README's program: a Newton loop as a deal.II user writes it, small-strain
// elasticity on deal.II's own matrices, with contact. A punch is pressed 0.02
// into a block; lines that contact adds are marked with "// contact".

#include <mortar_contact/mortar_contact.h> // contact

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>

#include <deal.II/grid/grid_generator.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>

#include <deal.II/numerics/vector_tools.h>

#include <iostream>

using namespace dealii;

constexpr int    dim    = 2;
constexpr double lambda = 576.9, mu = 384.6; // E = 1000, nu = 0.3

void
assemble_elasticity(const DoFHandler<dim>           &dof_handler,
                    const Vector<double>            &u,
                    const AffineConstraints<double> &constraints,
                    SparseMatrix<double>            &matrix,
                    Vector<double>                  &rhs)
{
  const FiniteElement<dim>            &fe = dof_handler.get_fe();
  const FEValuesExtractors::Vector     displacement(0);
  FEValues<dim>                        fe_values(fe,
                          QGauss<dim>(2),
                          update_gradients | update_JxW_values);
  const unsigned int                   n = fe.n_dofs_per_cell();
  FullMatrix<double>                   K(n, n);
  Vector<double>                       r(n);
  std::vector<types::global_dof_index> dofs(n);
  std::vector<SymmetricTensor<2, dim>> strain(4);
  for (const auto &cell : dof_handler.active_cell_iterators())
    {
      fe_values.reinit(cell);
      fe_values[displacement].get_function_symmetric_gradients(u, strain);
      K = 0.;
      r = 0.;
      for (const unsigned int q : fe_values.quadrature_point_indices())
        for (unsigned int i = 0; i < n; ++i)
          {
            const auto e_i = fe_values[displacement].symmetric_gradient(i, q);
            const auto s_i =
              lambda * trace(e_i) * unit_symmetric_tensor<dim>() +
              2. * mu * e_i;
            r(i) -= s_i * strain[q] * fe_values.JxW(q);
            for (unsigned int j = 0; j < n; ++j)
              K(i, j) += s_i *
                         fe_values[displacement].symmetric_gradient(j, q) *
                         fe_values.JxW(q);
          }
      cell->get_dof_indices(dofs);
      constraints.distribute_local_to_global(K, r, dofs, matrix, rhs);
    }
}

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // block [0,3]x[0,1], punch [1,2]x[1,2]; ids: 1 base, 2 block's top, 7 punch's
  // foot, 8 punch's head
  Triangulation<dim> block, punch, tria;
  GridGenerator::subdivided_hyper_rectangle(block,
                                            {24, 8},
                                            Point<dim>(0., 0.),
                                            Point<dim>(3., 1.));
  GridGenerator::subdivided_hyper_rectangle(punch,
                                            {7, 7},
                                            Point<dim>(1., 1.),
                                            Point<dim>(2., 2.));
  for (const auto &cell : punch.active_cell_iterators())
    cell->set_material_id(1);
  GridGenerator::merge_triangulations(block, punch, tria, 0.);
  for (const auto &cell : tria.active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary())
        {
          const double y        = cell->face(f)->center()[1];
          const bool   is_punch = cell->material_id() == 1;
          if (y < 1e-10)
            cell->face(f)->set_boundary_id(1);
          else if (std::abs(y - 1.) < 1e-10)
            cell->face(f)->set_boundary_id(is_punch ? 7 : 2);
          else if (std::abs(y - 2.) < 1e-10)
            cell->face(f)->set_boundary_id(8);
        }

  const MappingQ<dim> mapping(1);
  const FESystem<dim> fe(FE_Q<dim>(1), dim);
  DoFHandler<dim>     dof_handler(tria);
  dof_handler.distribute_dofs(fe);

  MortarContact::ContactParameters     parameters;               // contact
  MortarContact::ContactInterface<dim> contact("punch on block", // contact
                                               parameters,       // contact
                                               MPI_COMM_WORLD);  // contact
  const auto modulus_of_cell = [](const auto &) {                // contact
    return MortarContact::bulk_contact_modulus(1000., 0.3);      // contact
  };                                                             // contact
  contact.add_secondary(dof_handler,                             // contact
                        mapping,                                 // contact
                        MortarContact::boundary_ids({2}),        // contact
                        modulus_of_cell);                        // contact
  contact.add_primary(dof_handler,                               // contact
                      mapping,                                   // contact
                      MortarContact::boundary_ids({7}),          // contact
                      modulus_of_cell);                          // contact
  contact.setup();                                               // contact

  Vector<double>       u(dof_handler.n_dofs()), du(u.size()), rhs(u.size());
  SparsityPattern      sparsity;
  SparseMatrix<double> matrix;
  for (unsigned int iteration = 0; iteration < 20; ++iteration)
    {
      AffineConstraints<double> constraints;
      VectorTools::interpolate_boundary_values(
        dof_handler, 1, Functions::ZeroFunction<dim>(dim), constraints);
      Vector<double> head({0., iteration == 0 ? -0.02 : 0.});
      VectorTools::interpolate_boundary_values(
        dof_handler, 8, Functions::ConstantFunction<dim>(head), constraints);
      constraints.close();

      contact.update(u, 1.);                  // contact
      if (contact.report().couplings_changed) // contact
        {
          DynamicSparsityPattern dsp(dof_handler.n_dofs());
          DoFTools::make_sparsity_pattern(dof_handler, dsp, constraints, false);
          contact.add_couplings(dsp, constraints); // contact
          sparsity.copy_from(dsp);
          matrix.reinit(sparsity);
        }
      matrix = 0.;
      rhs    = 0.;
      assemble_elasticity(dof_handler, u, constraints, matrix, rhs);
      contact.assemble(matrix, rhs, constraints); // contact

      std::cout << "iteration " << iteration << "  residual " << rhs.l2_norm()
                << std::endl;
      if (iteration > 0 && rhs.l2_norm() < 1e-9)
        {
          contact.commit(1.); // contact
          std::cout << contact.report().brief() << std::endl;
          // balance, and bounds from springs in series: both columns laterally
          // free but no spreading (lower, with the penetration), plane strain
          // and a rigid block (upper)
          const double force = -contact.report().force[1];
          const double d     = contact.report().largest_penetration;
          const double lower = (0.02 - d) * 1000. / 2.;
          const double upper = 0.02 * 1346. / 1.;
          return (contact.check_balance() < 1e-13 && force > lower &&
                  force < upper) ?
                   0 :
                   1;
        }

      SparseDirectUMFPACK solver;
      solver.initialize(matrix);
      solver.vmult(du, rhs);
      constraints.distribute(du);
      du *= (iteration == 0) ? 1. : contact.largest_safe_step(u, du); // contact
      u += du;
    }
  std::cout << "no convergence" << std::endl;
  return 1;
}
