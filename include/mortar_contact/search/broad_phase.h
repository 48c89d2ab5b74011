// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_search_broad_phase_h
#define mortar_contact_search_broad_phase_h

#include <mortar_contact/geometry/facet.h>

#include <functional>
#include <memory>
#include <vector>

namespace MortarContact
{
  /// Axis-parallel box [m].
  template <int dim>
  struct Box
  {
    Tensor<1, dim> low;  ///< Lowest corner [m].
    Tensor<1, dim> high; ///< Highest corner [m].

    /// Between ranks.
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &low &high;
    }
  };

  /// A box that meets all others.
  template <int dim>
  Box<dim>
  everywhere();

  /// Smallest box around a facet.
  template <int dim>
  Box<dim>
  box_around(const Facet<dim> &facet);

  /// Smallest box around two facets, or one at two times.
  template <int dim>
  Box<dim>
  box_around(const Facet<dim> &a, const Facet<dim> &b);

  /// Enlarge @p box to hold @p x.
  template <int dim>
  void
  extend(Box<dim> &box, const Tensor<1, dim> &x);

  /// Enlarge @p box by @p by [m] in all directions.
  template <int dim>
  void
  inflate(Box<dim> &box, const double by);

  /// Smallest box around all @p boxes; there must be one.
  template <int dim>
  Box<dim>
  box_around(const std::vector<Box<dim>> &boxes);

  /// At most @p n boxes that together hold all @p boxes: those that lie near
  /// each other are put into one.
  template <int dim>
  std::vector<Box<dim>>
  join(std::vector<Box<dim>> boxes, const unsigned int n);

  /// Whether the boxes have a point in common.
  template <int dim>
  bool
  intersect(const Box<dim> &a, const Box<dim> &b);

  /// An R-tree over boxes: finds all that intersect a query box, O(log n) each.
  template <int dim>
  class BroadPhase
  {
  public:
    /// An R-tree over @p boxes.
    explicit BroadPhase(const std::vector<Box<dim>> &boxes);
    ~BroadPhase();

    /// Numbers of all boxes that intersect @p box, in ascending order.
    std::vector<unsigned int>
    find(const Box<dim> &box) const;

  private:
    struct Tree;
    std::unique_ptr<Tree> tree;
  };
} // namespace MortarContact

#endif
