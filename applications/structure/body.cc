// SPDX-License-Identifier: LGPL-2.1-or-later
#include "body.h"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace Structure
{
  namespace
  {
    /// The nodes of all ranks, in the order of ranks.
    template <int dim>
    std::vector<BoundaryNode<dim>>
    of_all_ranks(const std::vector<BoundaryNode<dim>> &nodes,
                 const MPI_Comm                        communicator)
    {
      std::vector<BoundaryNode<dim>> result;
      for (auto &of_rank : Utilities::MPI::all_gather(communicator, nodes))
        std::move(of_rank.begin(), of_rank.end(), std::back_inserter(result));
      return result;
    }
  } // namespace


  template <int dim>
  std::vector<BoundaryNode<dim>>
  Body<dim>::boundary_nodes(const std::set<types::boundary_id> &ids) const
  {
    std::vector<BoundaryNode<dim>> nodes;
    visit_boundary_nodes(ids, [&](const BoundaryNode<dim> &node) {
      nodes.push_back(node);
    });
    return of_all_ranks(nodes, communicator);
  }


  template <int dim>
  std::vector<BoundaryNode<dim>>
  Body<dim>::nodes_where(Expression<dim> &formula) const
  {
    std::vector<BoundaryNode<dim>>    nodes;
    std::set<types::global_dof_index> seen;
    visit_nodes([&](const BoundaryNode<dim> &node) {
      if (formula.value(node.x, 0.) != 0. && seen.insert(node.dofs[0]).second)
        nodes.push_back(node);
    });
    return of_all_ranks(nodes, communicator);
  }


  template <int dim>
  BoundaryNode<dim>
  Body<dim>::nearest_node(const Point<dim> &x) const
  {
    const auto nearer = [&x](const BoundaryNode<dim> &a,
                             const BoundaryNode<dim> &b) {
      const double to_a = x.distance(a.x), to_b = x.distance(b.x);
      return std::tie(to_a, a.cell) < std::tie(to_b, b.cell);
    };
    std::vector<BoundaryNode<dim>> nearest; // one, or none on this rank
    visit_nodes([&](const BoundaryNode<dim> &node) {
      if (nearest.empty())
        nearest.push_back(node);
      else if (nearer(node, nearest.front()))
        nearest.front() = node;
    });
    const auto of_ranks = of_all_ranks(nearest, communicator);
    Assert(!of_ranks.empty(), ExcInternalError());
    return *std::min_element(of_ranks.begin(), of_ranks.end(), nearer);
  }


  template class Body<2>;
  template class Body<3>;
} // namespace Structure
