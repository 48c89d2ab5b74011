// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/search/broad_phase.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/utilities.h>

#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <limits>

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
  Box<dim>
  box_around(const Facet<dim> &a, const Facet<dim> &b)
  {
    Box<dim> box = box_around(a);
    for (unsigned int v = 0; v < b.n_vertices; ++v)
      extend(box, b.x[v]);
    return box;
  }


  template <int dim>
  Box<dim>
  everywhere()
  {
    // differences of corners must be numbers, too
    constexpr double far = 0.1 * std::numeric_limits<double>::max();
    Box<dim>         box;
    inflate(box, far);
    return box;
  }


  template <int dim>
  std::vector<Box<dim>>
  join(std::vector<Box<dim>> boxes, const unsigned int n)
  {
    if (boxes.size() <= n)
      return boxes;
    const Box<dim> all = box_around(boxes);
    if (n == 1)
      return {all};
    // halves, by the centres along the longest axis
    unsigned int axis = 0;
    for (unsigned int i = 1; i < dim; ++i)
      if (all.high[i] - all.low[i] > all.high[axis] - all.low[axis])
        axis = i;
    const auto middle = boxes.begin() + boxes.size() / 2;
    std::nth_element(boxes.begin(),
                     middle,
                     boxes.end(),
                     [&](const Box<dim> &a, const Box<dim> &b) {
                       return a.low[axis] + a.high[axis] <
                              b.low[axis] + b.high[axis];
                     });
    std::vector<Box<dim>> result =
      join(std::vector<Box<dim>>(boxes.begin(), middle), n / 2);
    for (const Box<dim> &box :
         join(std::vector<Box<dim>>(middle, boxes.end()), n - n / 2))
      result.push_back(box);
    return result;
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
  template Box<2>
  box_around(const Facet<2> &, const Facet<2> &);
  template Box<3>
  box_around(const Facet<3> &, const Facet<3> &);
  template Box<2>
  everywhere();
  template Box<3>
  everywhere();
  template std::vector<Box<2>>
  join(std::vector<Box<2>>, const unsigned int);
  template std::vector<Box<3>>
  join(std::vector<Box<3>>, const unsigned int);
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
