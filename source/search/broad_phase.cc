// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/search/broad_phase.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/utilities.h>

#include <deal.II/numerics/rtree.h>

#include <algorithm>

namespace MortarContact
{
  namespace
  {
    template <int dim>
    BoundingBox<dim>
    bounding_box(const Box<dim> &box)
    {
      return BoundingBox<dim>({Point<dim>(box.low), Point<dim>(box.high)});
    }
  } // namespace


  template <int dim>
  Box<dim>
  box_around(const Facet<dim> &facet)
  {
    Box<dim> box = {facet.x[0], facet.x[0]};
    for (unsigned int a = 1; a < facet.n_vertices; ++a)
      extend(box, facet.x[a]);
    return box;
  }


  template <int dim>
  void
  extend(Box<dim> &box, const Tensor<1, dim> &x)
  {
    for (unsigned int i = 0; i < dim; ++i)
      {
        box.low[i]  = std::min(box.low[i], x[i]);
        box.high[i] = std::max(box.high[i], x[i]);
      }
  }


  template <int dim>
  void
  inflate(Box<dim> &box, const double by)
  {
    for (unsigned int i = 0; i < dim; ++i)
      {
        box.low[i] -= by;
        box.high[i] += by;
      }
  }


  template <int dim>
  Box<dim>
  box_around(const std::vector<Box<dim>> &boxes)
  {
    Assert(!boxes.empty(), ExcInternalError());
    Box<dim> all = boxes[0];
    for (const auto &box : boxes)
      {
        extend(all, box.low);
        extend(all, box.high);
      }
    return all;
  }


  template <int dim>
  bool
  intersect(const Box<dim> &a, const Box<dim> &b)
  {
    for (unsigned int i = 0; i < dim; ++i)
      if (a.low[i] > b.high[i] || b.low[i] > a.high[i])
        return false;
    return true;
  }


  template <int dim>
  struct BroadPhase<dim>::Tree
  {
    using Leaf = std::pair<BoundingBox<dim>, unsigned int>;
    decltype(pack_rtree(std::vector<Leaf>())) rtree;
  };


  template <int dim>
  BroadPhase<dim>::BroadPhase(const std::vector<Box<dim>> &boxes)
    : tree(std::make_unique<Tree>())
  {
    std::vector<typename Tree::Leaf> leaves;
    leaves.reserve(boxes.size());
    for (unsigned int i = 0; i < boxes.size(); ++i)
      leaves.emplace_back(bounding_box(boxes[i]), i);
    tree->rtree = pack_rtree(leaves);
  }


  template <int dim>
  BroadPhase<dim>::~BroadPhase() = default;


  template <int dim>
  std::vector<unsigned int>
  BroadPhase<dim>::find(const Box<dim> &box) const
  {
    namespace bgi = boost::geometry::index;
    std::vector<unsigned int> found;
    for (auto it = tree->rtree.qbegin(bgi::intersects(bounding_box(box)));
         it != tree->rtree.qend();
         ++it)
      found.push_back(it->second);
    std::sort(found.begin(), found.end());
    return found;
  }


  template Box<2>
  box_around(const Facet<2> &);
  template Box<3>
  box_around(const Facet<3> &);
  template Box<2>
  box_around(const std::vector<Box<2>> &);
  template Box<3>
  box_around(const std::vector<Box<3>> &);
  template bool
  intersect(const Box<2> &, const Box<2> &);
  template bool
  intersect(const Box<3> &, const Box<3> &);
  template void
  extend(Box<2> &, const Tensor<1, 2> &);
  template void
  extend(Box<3> &, const Tensor<1, 3> &);
  template void
  inflate(Box<2> &, const double);
  template void
  inflate(Box<3> &, const double);
  template class BroadPhase<2>;
  template class BroadPhase<3>;
} // namespace MortarContact
