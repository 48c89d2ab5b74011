// SPDX-License-Identifier: LGPL-2.1-or-later
#include "loads.h"

#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace Structure
{
  namespace
  {
    /// Conditions of one node whose directions differ by less than this are the
    /// same condition (a unit vector's rest after elimination).
    constexpr double same_direction = 1e-6;

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
  NodeConditions<dim>::NodeConditions(
    const std::vector<std::unique_ptr<Body<dim>>> &bodies,
    const std::vector<BoundaryCondition>          &conditions)
    : by_condition(conditions.size())
  {
    std::map<types::global_dof_index, unsigned int> node_of_dof;
    for (unsigned int c = 0; c < conditions.size(); ++c)
      {
        const BoundaryCondition &condition = conditions[c];
        const bool               symmetry =
          condition.type == BoundaryCondition::Type::symmetry;
        if (!symmetry &&
            condition.type != BoundaryCondition::Type::displacement)
          continue;

        std::array<int, dim> formula_of;
        formula_of.fill(-1);
        if (!symmetry)
          for (unsigned int i = 0; i < dim; ++i)
            if (condition.values[i] != "free")
              {
                formula_of[i] = formulas.size();
                formulas.emplace_back(condition.values[i],
                                      "Boundary conditions/" + condition.name +
                                        "/" + "xyz"[i]);
              }

        for (const auto &body : bodies)
          {
            if (body->name != condition.body)
              continue;
            const FiniteElement<dim>            &fe     = *body->fe;
            const FiniteElement<dim>            &scalar = fe.base_element(0);
            std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
            // symmetry planes are plane: one normal per face
            for (const auto &cell : body->dof_handler.active_cell_iterators())
              for (const unsigned int f : cell->face_indices())
                {
                  if (!cell->face(f)->at_boundary() ||
                      condition.boundaries.count(
                        cell->face(f)->boundary_id()) == 0)
                    continue;
                  cell->get_dof_indices(dofs);

                  Tensor<1, dim> normal;
                  if (symmetry)
                    {
                      FEFaceValues<dim> face_values(*body->mapping,
                                                    fe,
                                                    *body->face_quadrature,
                                                    update_normal_vectors);
                      face_values.reinit(cell, f);
                      for (const unsigned int q :
                           face_values.quadrature_point_indices())
                        normal += face_values.normal_vector(q);
                      normal /= normal.norm();
                      for (unsigned int i = 0; i < dim; ++i)
                        if (std::abs(normal[i]) < 1e-12)
                          normal[i] = 0.; // planes along the axes are exact
                      normal /= normal.norm();
                    }

                  for (unsigned int k = 0; k < scalar.n_dofs_per_cell(); ++k)
                    {
                      const Point<dim> p = scalar.unit_support_point(k);
                      if (!is_on_face<dim>(cell, f, p))
                        continue;
                      const auto first = body->numbering(
                        dofs[fe.component_to_system_index(0, k)]);
                      const auto inserted =
                        node_of_dof.try_emplace(first, nodes.size());
                      if (inserted.second)
                        {
                          Node node;
                          for (unsigned int i = 0; i < dim; ++i)
                            node.dofs[i] = body->numbering(
                              dofs[fe.component_to_system_index(i, k)]);
                          node.x =
                            body->mapping->transform_unit_to_real_cell(cell, p);
                          nodes.push_back(node);
                        }
                      Node      &node = nodes[inserted.first->second];
                      const auto add  = [&](const Tensor<1, dim> &a,
                                           const int             formula) {
                        // faces of one plane meet in a node: once is enough
                        for (const Row &row : node.rows)
                          if (row.formula == formula &&
                              (row.a - a).norm() < same_direction)
                            return;
                        node.rows.push_back({a, formula});
                      };
                      if (symmetry)
                        add(normal, -1);
                      for (unsigned int i = 0; i < dim; ++i)
                        if (formula_of[i] >= 0)
                          {
                            Tensor<1, dim> e;
                            e[i] = 1.;
                            add(e, formula_of[i]);
                          }
                      for (unsigned int i = 0; i < dim; ++i)
                        if (symmetry || formula_of[i] >= 0)
                          by_condition[c].emplace_back(node.dofs[i], i);
                    }
                }
          }
        auto &list = by_condition[c];
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
      }
  }


  template <int dim>
  void
  NodeConditions<dim>::add_line(
    const Node                                    &node,
    std::vector<std::pair<Tensor<1, dim>, double>> rows,
    AffineConstraints<double>                     &constraints) const
  {
    for (const auto dof : node.dofs)
      if (constraints.is_constrained(dof))
        return;

    // Gauss-Jordan elimination: each row gets the component with its largest
    // entry; rows that say nothing new are left out (the first one wins).
    std::array<int, dim> row_of;
    row_of.fill(-1);
    for (std::size_t r = 0; r < rows.size(); ++r)
      {
        for (unsigned int i = 0; i < dim; ++i)
          if (row_of[i] >= 0)
            {
              const double factor = rows[r].first[i];
              rows[r].first -= factor * rows[row_of[i]].first;
              rows[r].second -= factor * rows[row_of[i]].second;
            }
        unsigned int pivot = 0;
        for (unsigned int i = 1; i < dim; ++i)
          if (std::abs(rows[r].first[i]) > std::abs(rows[r].first[pivot]))
            pivot = i;
        if (std::abs(rows[r].first[pivot]) < same_direction)
          continue;
        const double scale = 1. / rows[r].first[pivot];
        rows[r].first *= scale;
        rows[r].second *= scale;
        for (unsigned int i = 0; i < dim; ++i)
          if (row_of[i] >= 0)
            {
              auto        &other  = rows[row_of[i]];
              const double factor = other.first[pivot];
              other.first -= factor * rows[r].first;
              other.second -= factor * rows[r].second;
            }
        row_of[pivot] = r;
      }

    for (unsigned int i = 0; i < dim; ++i)
      if (row_of[i] >= 0)
        {
          const auto &[a, b] = rows[row_of[i]];
          constraints.add_line(node.dofs[i]);
          for (unsigned int j = 0; j < dim; ++j)
            if (j != i && row_of[j] < 0 && a[j] != 0.)
              constraints.add_entry(node.dofs[i], node.dofs[j], -a[j]);
          constraints.set_inhomogeneity(node.dofs[i], b);
        }
  }


  template class NodeConditions<2>;
  template class NodeConditions<3>;
} // namespace Structure
