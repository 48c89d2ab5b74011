// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid_body.h"

#include "hex_cells.h"
#include "vtk_flags.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/fe/mapping_q.h>

#include <deal.II/grid/grid_tools.h>

#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/error_estimator.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>

namespace Structure
{
  namespace
  {
    /// Whether a support point, @p p on the reference cell, lies on a face: on
    /// the plane (line) through the face's vertices on the reference cell.
    template <int dim>
    bool
    is_on_face(const typename DoFHandler<dim>::active_cell_iterator &cell,
               const unsigned int                                    f,
               const Point<dim>                                     &p)
    {
      std::vector<Point<dim>> corners;
      for (const unsigned int v : cell->vertex_indices())
        for (const unsigned int w : cell->face(f)->vertex_indices())
          if (cell->vertex_index(v) == cell->face(f)->vertex_index(w))
            corners.push_back(cell->reference_cell().template vertex<dim>(v));
      Tensor<1, dim> normal;
      if constexpr (dim == 2)
        normal = cross_product_2d(corners[1] - corners[0]);
      else
        normal =
          cross_product_3d(corners[1] - corners[0], corners[2] - corners[0]);
      return std::abs(normal * (p - corners[0])) < 1e-10;
    }
  } // namespace


  template <int dim>
  SolidBody<dim>::SolidBody(const std::string        &name,
                            const Triangulation<dim> &mesh,
                            std::unique_ptr<Material> material,
                            const unsigned int        degree,
                            const bool                mean_dilatation,
                            const bool                is_whole,
                            const MPI_Comm            communicator)
    : MeshBody<dim, dim>(name, mesh, is_whole, communicator)
    , material(std::move(material))
    , mean_dilatation(mean_dilatation)
  {
    const bool simplices = this->has_simplices_only;
    AssertThrow(!mean_dilatation || (!simplices && degree == 1),
                ExcMessage("Body '" + name +
                           "': 'Mean dilatation' needs hexahedra "
                           "(quadrilaterals) of degree 1."));
    if (simplices)
      {
        mapping = std::make_unique<MappingFE<dim>>(FE_SimplexP<dim>(1));
        elements.push_back(FESystem<dim>(FE_SimplexP<dim>(degree), dim));
        quadrature      = std::make_unique<QGaussSimplex<dim>>(degree + 1);
        face_quadrature = std::make_unique<QGaussSimplex<dim - 1>>(degree + 1);
      }
    else
      {
        mapping = std::make_unique<MappingQ<dim>>(degree);
        elements.push_back(FESystem<dim>(FE_Q<dim>(degree), dim));
        quadrature      = std::make_unique<QGauss<dim>>(degree + 1);
        face_quadrature = std::make_unique<QGauss<dim - 1>>(degree + 1);
      }
    this->distribute_dofs();
    component = components_of(elements[0]);
    element   = std::make_unique<Element<dim>>(*this);
    load_values =
      std::make_unique<FEValues<dim>>(*mapping,
                                      elements[0],
                                      *quadrature,
                                      update_values | update_JxW_values |
                                        update_quadrature_points);
    face_values =
      std::make_unique<FEFaceValues<dim>>(*mapping,
                                          elements[0],
                                          *face_quadrature,
                                          update_values | update_gradients |
                                            update_JxW_values |
                                            update_normal_vectors |
                                            update_quadrature_points);
  }


  template <int dim>
  bool
  SolidBody<dim>::evaluate(const unsigned int    cell,
                           const Vector<double> &u,
                           const Vector<double> *,
                           const bool          with_tangent,
                           Vector<double>     &forces,
                           FullMatrix<double> &tangent)
  {
    return element->evaluate(
      local_cells[cell], u, with_tangent, forces, tangent);
  }


  template <int dim>
  std::unique_ptr<CellBatches<dim>>
  SolidBody<dim>::make_batches(const IndexSet &owned,
                               const IndexSet &relevant) const
  {
    if constexpr (dim == 3)
      if (HexCells::fit(*this))
        return std::make_unique<HexCells>(*this, owned, relevant);
    (void)owned;
    (void)relevant;
    return nullptr;
  }


  template <int dim>
  std::vector<double>
  SolidBody<dim>::gradient_jumps(const Vector<double> &u) const
  {
    Assert(this->is_whole(), ExcInternalError());
    // the estimator's own constant is h/24
    Vector<float> estimate(triangulation.n_active_cells());
    KellyErrorEstimator<dim>::estimate(*mapping,
                                       dof_handler,
                                       *face_quadrature,
                                       {},
                                       u,
                                       estimate,
                                       ComponentMask(),
                                       nullptr,
                                       1,
                                       triangulation.locally_owned_subdomain());
    std::vector<double> result(estimate.size());
    for (unsigned int c = 0; c < result.size(); ++c)
      result[c] =
        material->shear_modulus * double(estimate(c)) * double(estimate(c));
    Utilities::MPI::sum(result, this->communicator, result);
    return result;
  }


  template <int dim>
  double
  SolidBody<dim>::energy(const unsigned int cell, const Vector<double> &u)
  {
    Vector<double>     forces(u.size());
    FullMatrix<double> none;
    element->evaluate(local_cells[cell], u, false, forces, none);
    return element->state().energy;
  }


  template <int dim>
  void
  SolidBody<dim>::mass(const unsigned int cell, FullMatrix<double> &matrix)
  {
    element->mass(local_cells[cell], matrix);
  }


  template <int dim>
  void
  SolidBody<dim>::add_load(const unsigned int    cell,
                           Load<dim>            &load,
                           const Vector<double> &u,
                           const double          time,
                           Vector<double>       &forces,
                           FullMatrix<double>   &tangent)
  {
    using Type      = typename Load<dim>::Type;
    const auto dead = [&](const FEValuesBase<dim> &values) {
      for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
        for (unsigned int a = 0; a < component.size(); ++a)
          if (load.of_component[component[a]] >= 0)
            forces(a) += load.formulas[load.of_component[component[a]]].value(
                           values.quadrature_point(q), time) *
                         values.shape_value(a, q) * values.JxW(q);
    };
    if (load.type == Type::body_force)
      {
        load_values->reinit(local_cells[cell]);
        dead(*load_values);
        return;
      }
    for (const unsigned int f : local_cells[cell]->face_indices())
      {
        const auto face = local_cells[cell]->face(f);
        if (!face->at_boundary() ||
            load.boundaries.count(face->boundary_id()) == 0)
          continue;
        face_values->reinit(local_cells[cell], f);
        if (load.type == Type::traction)
          dead(*face_values);
        else
          add_pressure(*face_values, load, u, time, forces, tangent);
      }
  }


  template <int dim>
  void
  SolidBody<dim>::add_pressure(const FEFaceValues<dim> &fe_values,
                               Load<dim>               &load,
                               const Vector<double>    &u,
                               const double             time,
                               Vector<double>          &forces,
                               FullMatrix<double>      &tangent) const
  {
    const bool is_dead = material->is_linear;
    for (const unsigned int q : fe_values.quadrature_point_indices())
      {
        const double     w = fe_values.JxW(q);
        const Point<dim> x = fe_values.quadrature_point(q);
        // Nanson: n da = J F^-T N dA; dead on small strains
        const double p = load.formulas[0].value(x, time) * w;
        Tensor<1, 3> N;
        for (unsigned int i = 0; i < dim; ++i)
          N[i] = fe_values.normal_vector(q)[i];
        Tensor<2, 3> F = deformation_gradient<dim>(
          fe_values, component, is_dead ? Vector<double>(u.size()) : u, q);
        const double       J = determinant(F);
        const Tensor<2, 3> H = transpose(invert(F));
        const Tensor<1, 3> n = J * (H * N);
        for (unsigned int a = 0; a < component.size(); ++a)
          {
            forces(a) -= p * n[component[a]] * fe_values.shape_value(a, q);
            if (tangent.empty() || is_dead)
              continue;
            const unsigned int i = component[a];
            for (unsigned int b = 0; b < component.size(); ++b)
              {
                const unsigned int   k = component[b];
                const Tensor<1, dim> g = fe_values.shape_grad(b, q);
                double               d = 0.;
                for (unsigned int K = 0; K < dim; ++K)
                  for (unsigned int L = 0; L < dim; ++L)
                    d +=
                      J * (H[i][K] * H[k][L] - H[i][L] * H[k][K]) * N[K] * g[L];
                tangent(a, b) += p * d * fe_values.shape_value(a, q);
              }
          }
      }
  }


  template <int dim>
  DoFPlace<dim>
  SolidBody<dim>::place_of(const unsigned int cell,
                           const unsigned int dof) const
  {
    const auto       node = elements[0].system_to_component_index(dof);
    const Point<dim> x    = mapping->transform_unit_to_real_cell(
      local_cells[cell],
      elements[0].base_element(0).unit_support_point(node.second));
    return {x, node.first, Tensor<1, dim>(x)};
  }


  template <int dim>
  void
  SolidBody<dim>::visit_boundary_nodes(const std::set<types::boundary_id> &ids,
                                       const Visitor &visit) const
  {
    const FiniteElement<dim>            &scalar = elements[0].base_element(0);
    std::vector<types::global_dof_index> dofs(elements[0].n_dofs_per_cell());
    FEFaceValues<dim>                    normals(*mapping,
                              elements[0],
                              *face_quadrature,
                              update_normal_vectors);
    for (const auto &cell : local_cells)
      for (const unsigned int f : cell->face_indices())
        {
          if (!cell->face(f)->at_boundary() ||
              ids.count(cell->face(f)->boundary_id()) == 0)
            continue;
          cell->get_dof_indices(dofs);
          BoundaryNode<dim> node;
          node.cell = this->number_of(cell);
          // symmetry planes are plane: one normal per face
          normals.reinit(cell, f);
          for (const unsigned int q : normals.quadrature_point_indices())
            node.normal += normals.normal_vector(q);
          node.normal /= node.normal.norm();
          for (unsigned int k = 0; k < scalar.n_dofs_per_cell(); ++k)
            {
              const Point<dim> p = scalar.unit_support_point(k);
              if (!is_on_face<dim>(cell, f, p))
                continue;
              for (unsigned int i = 0; i < dim; ++i)
                node.dofs[i] = this->numbering(
                  dofs[elements[0].component_to_system_index(i, k)]);
              node.x = mapping->transform_unit_to_real_cell(cell, p);
              visit(node);
            }
        }
  }


  template <int dim>
  void
  SolidBody<dim>::visit_nodes(const Visitor &visit) const
  {
    const FiniteElement<dim>            &scalar = elements[0].base_element(0);
    std::vector<types::global_dof_index> dofs(elements[0].n_dofs_per_cell());
    for (const auto &cell : local_cells)
      {
        cell->get_dof_indices(dofs);
        for (unsigned int k = 0; k < scalar.n_dofs_per_cell(); ++k)
          {
            BoundaryNode<dim> node;
            node.cell = this->number_of(cell);
            node.x    = mapping->transform_unit_to_real_cell(
              cell, scalar.unit_support_point(k));
            for (unsigned int i = 0; i < dim; ++i)
              node.dofs[i] = this->numbering(
                dofs[elements[0].component_to_system_index(i, k)]);
            visit(node);
          }
      }
  }


  template <int dim>
  void
  SolidBody<dim>::add_to(MortarContact::ContactInterface<dim> &interface,
                         const bool                            secondary,
                         const MortarContact::FaceSelection   &faces) const
  {
    const double modulus = material->contact_modulus;
    const auto   of_cell = [modulus](const auto &) { return modulus; };
    if (secondary)
      interface.add_secondary(
        dof_handler, *mapping, faces, of_cell, this->name, this->numbering);
    else
      interface.add_primary(
        dof_handler, *mapping, faces, of_cell, this->name, this->numbering);
  }



  template <int dim>
  void
  SolidBody<dim>::write(const ValuesOfCell &values_of_cell,
                        const std::string  &file,
                        const MPI_Comm      communicator)
  {
    // displacements in the body's own numbering, and means over cells
    Vector<double>     displacement(dof_handler.n_dofs());
    const unsigned int n_cells = triangulation.n_active_cells();
    Vector<double>     pressure(n_cells), mises(n_cells), volume_ratio(n_cells);
    std::vector<Vector<double>> stress(dim == 2 ? 4 : 6,
                                       Vector<double>(n_cells));
    std::vector<types::global_dof_index> dofs(elements[0].n_dofs_per_cell());
    for (unsigned int i = 0; i < local_cells.size(); ++i)
      {
        const Vector<double> &values = values_of_cell(i);
        local_cells[i]->get_dof_indices(dofs);
        for (unsigned int a = 0; a < dofs.size(); ++a)
          displacement(dofs[a]) = values(a);
        energy(i, values);
        const unsigned int           c = local_cells[i]->active_cell_index();
        const SymmetricTensor<2, 3> &s = state().stress;
        pressure(c)                    = -trace(s) / 3.;
        mises(c)                       = std::sqrt(1.5) * deviator(s).norm();
        volume_ratio(c)                = state().volume_ratio;
        const unsigned int components[6][2] = {
          {0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}};
        for (unsigned int k = 0; k < stress.size(); ++k)
          stress[k](c) = s[components[k][0]][components[k][1]];
      }

    DataOut<dim> data_out;
    data_out.attach_dof_handler(dof_handler);
    data_out.add_data_vector(
      displacement,
      std::vector<std::string>(dim, "displacement"),
      DataOut<dim>::type_dof_data,
      std::vector<DataComponentInterpretation::DataComponentInterpretation>(
        dim, DataComponentInterpretation::component_is_part_of_vector));
    data_out.add_data_vector(pressure,
                             "pressure",
                             DataOut<dim>::type_cell_data);
    data_out.add_data_vector(mises, "von_Mises", DataOut<dim>::type_cell_data);
    data_out.add_data_vector(volume_ratio,
                             "volume_ratio",
                             DataOut<dim>::type_cell_data);
    const char *const names[6] = {"xx", "yy", "zz", "xy", "yz", "xz"};
    for (unsigned int i = 0; i < stress.size(); ++i)
      data_out.add_data_vector(stress[i],
                               std::string("stress_") + names[i],
                               DataOut<dim>::type_cell_data);
    data_out.build_patches(*mapping, elements[0].degree);
    data_out.set_flags(fast_vtk_flags());
    data_out.write_vtu_in_parallel(file, communicator);
  }


  template class SolidBody<2>;
  template class SolidBody<3>;
} // namespace Structure
