// SPDX-License-Identifier: LGPL-2.1-or-later

// Two beams at finite strain: the upper one is bent down by a load at its end.
// In plain.cc, the same program without contact, it passes through the lower
// one. The README beside this file walks through the lines between the two.

// @sect3{Include files}

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/utilities.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/vector_tools.h>

#include <mortar_contact/mortar_contact.h>

#include <cmath>
#include <fstream>
#include <iostream>

using namespace dealii;

// @sect3{The beams}

// Two strips [0,10] x [0,0.5] with a gap of 0.2 between them, clamped on the
// left, with quadratic elements, which bend without locking. Boundary ids: 1
// the clamped ends, 2 the free end of the upper beam with the load; 3 the top
// of the lower beam and 4 the bottom of the upper one, which look at each
// other.
constexpr int    dim    = 2;
constexpr double length = 10., height = 0.5, gap = 0.2;
constexpr double E = 1000., nu = 0.3, load = 0.02;
constexpr double mu     = E / (2. * (1. + nu)),
                 lambda = 2. * mu * nu / (1. - 2. * nu);

class TwoBeams
{
public:
  TwoBeams();

  /// @return Whether the result agrees with beam theory.
  bool
  run();

private:
  void
  make_mesh();

  void
  set_up();

  bool
  solve_step(const double time);

  void
  assemble(const double time);

  void
  write(const unsigned int step) const;

  double
  deflection(const Point<dim> &end) const;

  Triangulation<dim>        mesh;
  const FESystem<dim>       fe;
  DoFHandler<dim>           dof_handler;
  AffineConstraints<double> constraints;
  SparsityPattern           sparsity;
  SparseMatrix<double>      matrix;
  Vector<double>            u, du, rhs;

  MortarContact::ContactInterface<dim> contact;
};


namespace
{
  MortarContact::ContactParameters
  contact_parameters()
  {
    MortarContact::ContactParameters parameters;
    parameters.friction.coefficient = 0.3;
    parameters.stiffness_scale      = 10.;
    return parameters;
  }
} // namespace


TwoBeams::TwoBeams()
  : fe(FE_Q<dim>(2), dim)
  , dof_handler(mesh)
  , contact("beams", contact_parameters(), MPI_COMM_WORLD)
{}


void
TwoBeams::make_mesh()
{
  Triangulation<dim> lower, upper;
  GridGenerator::subdivided_hyper_rectangle(lower,
                                            {40, 2},
                                            Point<dim>(0., 0.),
                                            Point<dim>(length, height));
  GridGenerator::subdivided_hyper_rectangle(upper,
                                            {30, 2},
                                            Point<dim>(0., height + gap),
                                            Point<dim>(length,
                                                       2. * height + gap));
  GridGenerator::merge_triangulations(lower, upper, mesh, 0.);
  for (const auto &cell : mesh.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary())
        {
          const Point<dim> x        = face->center();
          const bool       is_upper = x[1] > height + 0.5 * gap;
          if (x[0] < 1e-10)
            face->set_boundary_id(1);
          else if (is_upper && x[0] > length - 1e-10)
            face->set_boundary_id(2);
          else if (std::abs(x[1] - height) < 1e-10)
            face->set_boundary_id(3);
          else if (std::abs(x[1] - height - gap) < 1e-10)
            face->set_boundary_id(4);
        }
}


void
TwoBeams::set_up()
{
  dof_handler.distribute_dofs(fe);
  VectorTools::interpolate_boundary_values(dof_handler,
                                           1,
                                           Functions::ZeroFunction<dim>(dim),
                                           constraints);
  constraints.close();
  u.reinit(dof_handler.n_dofs());
  du.reinit(u);
  rhs.reinit(u);

  const auto modulus_of_cell = [](const auto &) {
    return MortarContact::bulk_contact_modulus(E, nu);
  };
  const MappingQ<dim> mapping(1);
  contact.add_secondary(dof_handler,
                        mapping,
                        MortarContact::boundary_ids({3}),
                        modulus_of_cell);
  contact.add_primary(dof_handler,
                      mapping,
                      MortarContact::boundary_ids({4}),
                      modulus_of_cell);
  contact.setup();
}


// @sect3{Forces and tangent}

// A neo-Hookean solid, W = mu/2 (F:F - 2 - 2 ln J) + lambda/2 ln^2 J: first
// Piola-Kirchhoff stress P = mu (F - F^-T) + lambda ln J F^-T. The right-hand
// side is minus the residual: load less internal forces.
void
TwoBeams::assemble(const double time)
{
  matrix = 0.;
  rhs    = 0.;
  const FEValuesExtractors::Vector     displacement(0);
  FEValues<dim>                        values(fe,
                       QGauss<dim>(3),
                       update_gradients | update_JxW_values);
  FEFaceValues<dim>                    face_values(fe,
                                QGauss<dim - 1>(3),
                                update_values | update_JxW_values);
  const unsigned int                   n = fe.n_dofs_per_cell();
  FullMatrix<double>                   K(n, n);
  Vector<double>                       f(n);
  std::vector<types::global_dof_index> dofs(n);
  std::vector<Tensor<2, dim>>          gradients(values.n_quadrature_points);
  for (const auto &cell : dof_handler.active_cell_iterators())
    {
      values.reinit(cell);
      values[displacement].get_function_gradients(u, gradients);
      K = 0.;
      f = 0.;
      for (const unsigned int q : values.quadrature_point_indices())
        {
          const Tensor<2, dim> F =
            gradients[q] + Tensor<2, dim>(unit_symmetric_tensor<dim>());
          const Tensor<2, dim> F_inverse   = invert(F);
          const Tensor<2, dim> F_transpose = transpose(F_inverse);
          const double         log_J       = std::log(determinant(F));
          const Tensor<2, dim> P =
            mu * (F - F_transpose) + lambda * log_J * F_transpose;
          for (unsigned int j = 0; j < n; ++j)
            {
              const Tensor<2, dim> H  = values[displacement].gradient(j, q);
              const Tensor<2, dim> HF = H * F_inverse;
              const Tensor<2, dim> dP =
                mu * H + (mu - lambda * log_J) * transpose(F_inverse * HF) +
                lambda * trace(HF) * F_transpose;
              for (unsigned int i = 0; i < n; ++i)
                K(i, j) +=
                  scalar_product(values[displacement].gradient(i, q), dP) *
                  values.JxW(q);
              f(j) -= scalar_product(H, P) * values.JxW(q);
            }
        }
      for (const unsigned int face : cell->face_indices())
        if (cell->face(face)->at_boundary() &&
            cell->face(face)->boundary_id() == 2)
          {
            face_values.reinit(cell, face);
            for (const unsigned int q : face_values.quadrature_point_indices())
              for (unsigned int i = 0; i < n; ++i)
                f(i) -= time * load / height *
                        face_values[displacement].value(i, q)[1] *
                        face_values.JxW(q);
          }
      cell->get_dof_indices(dofs);
      constraints.distribute_local_to_global(K, f, dofs, matrix, rhs);
    }
  contact.assemble(matrix, rhs, constraints);
}


// @sect3{One step}

// Newton's method. The pattern of the matrix is made where it has changed.
bool
TwoBeams::solve_step(const double time)
{
  for (unsigned int iteration = 0; iteration < 20; ++iteration)
    {
      contact.update(u, time);
      if (contact.report().couplings_changed || matrix.empty())
        {
          DynamicSparsityPattern dsp(dof_handler.n_dofs());
          DoFTools::make_sparsity_pattern(dof_handler, dsp, constraints, false);
          contact.add_couplings(dsp, constraints);
          sparsity.copy_from(dsp);
          matrix.reinit(sparsity);
        }
      assemble(time);
      const double residual = rhs.l2_norm();
      std::cout << "  " << residual;
      if (residual < 1e-10 * load)
        {
          std::cout << std::endl;
          return true;
        }
      SparseDirectUMFPACK solver;
      solver.initialize(matrix);
      solver.vmult(du, rhs);
      constraints.distribute(du);
      du *= contact.largest_safe_step(u, du);
      u += du;
    }
  std::cout << std::endl;
  return false;
}


void
TwoBeams::write(const unsigned int step) const
{
  DataOut<dim> data_out;
  data_out.attach_dof_handler(dof_handler);
  data_out.add_data_vector(
    u,
    std::vector<std::string>(dim, "displacement"),
    DataOut<dim>::type_dof_data,
    std::vector<DataComponentInterpretation::DataComponentInterpretation>(
      dim, DataComponentInterpretation::component_is_part_of_vector));
  data_out.build_patches(2);
  std::ofstream out("beams-" + std::to_string(step) + ".vtu");
  data_out.write_vtu(out);
}


// Of the node at the free end of a beam.
double
TwoBeams::deflection(const Point<dim> &end) const
{
  Vector<double> value(dim);
  VectorTools::point_value(dof_handler, u, end, value);
  return value(1);
}


// @sect3{All steps}

// The load grows in ten steps. In the end the beams touch at their ends: with
// the stiffness k = 3 E I/L^3 of each the upper one presses with F = (P - k
// g)/2, less a little for what beam theory leaves out.
bool
TwoBeams::run()
{
  make_mesh();
  set_up();
  const unsigned int n_steps = 10;
  for (unsigned int step = 1; step <= n_steps; ++step)
    {
      const double time = static_cast<double>(step) / n_steps;
      std::cout << "Step " << step << ", residuals";
      if (!solve_step(time))
        {
          std::cout << "No convergence." << std::endl;
          return false;
        }
      const MortarContact::StepAdvice advice = contact.advice();
      if (!advice.accept)
        {
          std::cout << advice.reason << std::endl;
          return false;
        }
      contact.commit(time);
      std::cout << "  " << contact.report().brief() << std::endl;
      write(step);
    }
  const double lower = deflection(Point<dim>(length, height));
  const double upper = deflection(Point<dim>(length, height + gap));
  std::cout << "Ends move by " << lower << " and " << upper << std::endl;
  const double k =
    3. * E / (1. - nu * nu) * std::pow(height, 3) / 12. / std::pow(length, 3);
  const double force = -contact.report().force[1];
  const double beams = 0.5 * (load - k * gap);
  std::cout << "Contact force " << force << ", of two beams " << beams
            << std::endl;
  return std::abs(force - beams) < 0.05 * beams;
}


int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  TwoBeams                         beams;
  return beams.run() ? 0 : 1;
}
