// SPDX-License-Identifier: LGPL-2.1-or-later
#include "loads.h"

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
  } // namespace


  template <int dim>
  Point<dim>
  point_of(const std::vector<double> &coordinates)
  {
    Point<dim> x;
    for (unsigned int i = 0; i < dim && i < coordinates.size(); ++i)
      x[i] = coordinates[i];
    return x;
  }


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

        const auto add_row =
          [&](const std::array<types::global_dof_index, dim> &dofs,
              const Point<dim>                               &x,
              const Tensor<1, dim>                           &a,
              const int                                       formula) {
            const auto inserted =
              node_of_dof.try_emplace(dofs[0], nodes.size());
            if (inserted.second)
              nodes.push_back({dofs, x, {}});
            Node &node = nodes[inserted.first->second];
            // faces of one plane meet in a node: once is enough
            for (const Row &row : node.rows)
              if (row.formula == formula && (row.a - a).norm() < same_direction)
                return;
            node.rows.push_back({a, formula});
          };
        const auto visit = [&](const BoundaryNode<dim> &node) {
          Tensor<1, dim> normal = node.normal;
          if (symmetry)
            {
              if (node.has_director)
                for (unsigned int i = 0; i < dim; ++i)
                  normal[i] = condition.plane_normal[i];
              for (unsigned int i = 0; i < dim; ++i)
                if (std::abs(normal[i]) < 1e-12)
                  normal[i] = 0.; // planes along the axes are exact
              normal /= normal.norm();
              add_row(node.dofs, node.x, normal, -1);
            }
          for (unsigned int i = 0; i < dim; ++i)
            {
              Tensor<1, dim> e;
              e[i] = 1.;
              if (formula_of[i] >= 0)
                add_row(node.dofs, node.x, e, formula_of[i]);
              if (symmetry || formula_of[i] >= 0)
                by_condition[c].emplace_back(node.dofs[i], i);
              if (condition.fixes_directors && node.has_director)
                add_row(node.director_dofs, node.x, e, -1);
            }
          if (symmetry && node.has_director)
            add_row(node.director_dofs, node.x, normal, -1);
        };
        for (const auto &body : bodies)
          {
            if (body->name != condition.body)
              continue;
            if (!condition.point.empty())
              visit(body->nearest_node(point_of<dim>(condition.point)));
            else if (!condition.where.empty())
              {
                const std::string entry =
                  "Boundary conditions/" + condition.name + "/Where";
                Expression<dim> where(condition.where, entry);
                for (const auto &node : body->nodes_where(where))
                  visit(node);
                AssertThrow(!by_condition[c].empty(),
                            ExcMessage("'" + entry + "' is '" +
                                       condition.where +
                                       "'; it is 0 at all nodes of '" +
                                       body->name + "'."));
              }
            else
              for (const auto &node :
                   body->boundary_nodes(condition.boundaries))
                visit(node);
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


  template Point<2>
  point_of(const std::vector<double> &);
  template Point<3>
  point_of(const std::vector<double> &);
  template class NodeConditions<2>;
  template class NodeConditions<3>;
} // namespace Structure
