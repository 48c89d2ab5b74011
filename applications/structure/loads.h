// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_loads_h
#define mortar_contact_structure_loads_h

#include "body.h"
#include "expression.h"

#include <deal.II/lac/affine_constraints.h>

#include <array>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace Structure
{
  /// What holds or loads the faces of a body with certain boundary ids (shells:
  /// edges), the surface of a shell, or one node.
  struct BoundaryCondition
  {
    enum class Type
    {
      displacement, ///< Components given as formulas, others free.
      symmetry,     ///< No displacement along the normal.
      traction,     ///< Dead load per undeformed area.
      pressure,     ///< Follows the normal, positive pushes.
      moment        ///< Of a shell's edges, per undeformed length.
    };

    std::string                  name;
    std::string                  body;
    std::set<types::boundary_id> boundaries;
    std::vector<double>          point; ///< The nearest node instead,
    std::string                  where; ///< or all nodes where it is not 0.
    bool                         on_surface      = false; ///< Of a shell.
    bool                         fixes_directors = false; ///< Of a shell.
    Tensor<1, 3>                 plane_normal; ///< Symmetry of a shell.
    Type                         type = Type::displacement;
    /// Formulas by component; "free" for no condition. Pressure: the first.
    std::array<std::string, 3> values = {{"free", "free", "free"}};
  };

  /// The first numbers of a list.
  template <int dim>
  Point<dim>
  point_of(const std::vector<double> &coordinates);

  /**
   * Linear conditions on the displacement of one node, a . u = b(t): from
   * displacement and symmetry conditions of any number of boundaries. They are
   * reduced to lines of an AffineConstraints object, so corners of inclined
   * symmetry planes need no special care.
   */
  template <int dim>
  class NodeConditions
  {
  public:
    NodeConditions(const std::vector<std::unique_ptr<Body<dim>>> &bodies,
                   const std::vector<BoundaryCondition>          &conditions);

    /// Add lines for the increment that leads from @p value (by global dof) to
    /// the prescribed values at @p time. Dofs that are constrained already are
    /// left alone.
    template <class Values>
    void
    add_lines(const Values              &value,
              const double               time,
              AffineConstraints<double> &constraints);

    /// Append the dofs of all conditioned nodes.
    void
    add_dofs(std::vector<types::global_dof_index> &dofs) const
    {
      for (const Node &node : nodes)
        dofs.insert(dofs.end(), node.dofs.begin(), node.dofs.end());
    }

    /// Global dofs by component that condition number @p c constrains.
    const std::vector<std::pair<types::global_dof_index, unsigned int>> &
    dofs_of(const unsigned int c) const
    {
      return by_condition[c];
    }

  private:
    struct Row
    {
      Tensor<1, dim> a;
      int            formula = -1; ///< -1: zero.
    };
    struct Node
    {
      std::array<types::global_dof_index, dim> dofs;
      Point<dim>                               x;
      std::vector<Row>                         rows;
    };
    std::vector<Node>            nodes;
    std::vector<Expression<dim>> formulas;
    std::vector<std::vector<std::pair<types::global_dof_index, unsigned int>>>
      by_condition;

    void
    add_line(const Node                                    &node,
             std::vector<std::pair<Tensor<1, dim>, double>> rows,
             AffineConstraints<double>                     &constraints) const;
  };


  template <int dim>
  template <class Values>
  void
  NodeConditions<dim>::add_lines(const Values              &value,
                                 const double               time,
                                 AffineConstraints<double> &constraints)
  {
    for (const Node &node : nodes)
      {
        std::vector<std::pair<Tensor<1, dim>, double>> rows;
        for (const Row &row : node.rows)
          {
            double b = (row.formula < 0) ?
                         0. :
                         formulas[row.formula].value(node.x, time);
            for (unsigned int i = 0; i < dim; ++i)
              if (row.a[i] != 0.)
                b -= row.a[i] * value(node.dofs[i]);
            rows.emplace_back(row.a, b);
          }
        add_line(node, rows, constraints);
      }
  }
} // namespace Structure

#endif
