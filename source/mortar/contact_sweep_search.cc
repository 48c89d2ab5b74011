// SPDX-License-Identifier: LGPL-2.1-or-later

// Which facets ContactSweep looks at: pairs that may touch, and motions that
// pass none.

#include <mortar_contact/mortar/contact_sweep.h>
#include <mortar_contact/search/broad_phase.h>
#include <mortar_contact/search/pair_filter.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace MortarContact
{
  namespace
  {
    /// A motion may close the gap and penetrate by this share of l more.
    constexpr double safe_share = 0.5;

    template <int dim>
    double
    largest_motion(const Skin<dim> &skin, const std::vector<Facet<dim>> &from)
    {
      double result = 0.;
      for (unsigned int f = 0; f < from.size(); ++f)
        for (unsigned int a = 0; a < from[f].n_vertices; ++a)
          result = std::max(
            result, (skin.facets[f].current.x[a] - from[f].x[a]).norm_square());
      return std::sqrt(result);
    }

    template <int dim>
    double
    largest(const ContactFacet<dim> &facet)
    {
      return *std::max_element(facet.length.begin(),
                               facet.length.begin() + facet.current.n_vertices);
    }
  } // namespace


  template <int dim>
  double
  ContactSweep<dim>::longest(const unsigned int f) const
  {
    const ContactFacet<dim> &facet = secondary.facets[f];
    const double             l_s   = largest(facet);
    const double             c_s =
      *std::max_element(facet.compliance.begin(),
                        facet.compliance.begin() + facet.current.n_vertices);
    if ((kernel.options.stiffness_side == StiffnessSide::secondary &&
         c_s > 0.) ||
        primary.sizes.largest_length <= l_s)
      return l_s;
    // grows with the primary's share
    return in_series(c_s,
                     l_s,
                     primary.sizes.largest_compliance,
                     primary.sizes.largest_length)
      .length;
  }


  template <int dim>
  double
  ContactSweep<dim>::reach(const unsigned int f) const
  {
    return kernel.options.ceiling * longest(f) + deepest_level;
  }


  template <int dim>
  bool
  ContactSweep<dim>::needs_search() const
  {
    if (searched_s.size() != secondary.facets.size() ||
        searched_p.size() != primary.facets.size())
      return true;
    return largest_motion(secondary, searched_s) +
             largest_motion(primary, searched_p) >
           margin;
  }


  template <int dim>
  void
  ContactSweep<dim>::search()
  {
    searched_s = current_facets(secondary);
    searched_p = current_facets(primary);
    last_reach = 0.;
    for (unsigned int f = 0; f < secondary.n_own; ++f)
      last_reach = std::max(last_reach, reach(f) + surface_offset);

    pairs = find_pairs(margin);
    drop_pairs_aside();
  }


  template <int dim>
  double
  ContactSweep<dim>::motion_of(const double diameters) const
  {
    return margin + diameters * secondary.sizes.mean_diameter;
  }


  template <int dim>
  std::vector<std::pair<unsigned int, unsigned int>>
  ContactSweep<dim>::candidates_after(const double diameters) const
  {
    if (diameters == 0.)
      return pairs;
    const auto wide = find_pairs(motion_of(diameters));
    std::vector<std::pair<unsigned int, unsigned int>> result;
    std::set_union(pairs.begin(),
                   pairs.end(),
                   wide.begin(),
                   wide.end(),
                   std::back_inserter(result));
    return result;
  }


  template <int dim>
  Box<dim>
  ContactSweep<dim>::region_of(const unsigned int f,
                               const Facet<dim>  &facet,
                               const double       motion) const
  {
    // the box of the facet, swept inwards over the depth that counts
    Box<dim>             box    = box_around(facet);
    const Tensor<1, dim> w      = centre_normal(facet);
    const Tensor<1, dim> inward = -reach(f) / w.norm() * w;
    for (unsigned int a = 0; a < facet.n_vertices; ++a)
      extend(box, Tensor<1, dim>(facet.x[a] + inward));
    inflate(box, motion + surface_offset);
    return box;
  }


  template <int dim>
  std::vector<Box<dim>>
  ContactSweep<dim>::regions(const double diameters) const
  {
    std::vector<Box<dim>> result;
    result.reserve(secondary.n_own);
    for (unsigned int f = 0; f < secondary.n_own; ++f)
      // commit() looks everywhere whether a released facet has opened
      result.push_back(
        is_released(f) ?
          everywhere<dim>() :
          region_of(f, secondary.facets[f].current, motion_of(diameters)));
    return result;
  }


  template <int dim>
  std::vector<std::pair<unsigned int, unsigned int>>
  ContactSweep<dim>::find_pairs(const double motion) const
  {
    std::vector<std::pair<unsigned int, unsigned int>> found;
    if (obstacle != nullptr)
      {
        for (unsigned int f = 0; f < secondary.n_own; ++f)
          if (secondary.facets[f].compliance[0] > 0.)
            found.emplace_back(f, 0);
        return found;
      }
    if (secondary.n_own == 0 || searched_p.empty())
      return found;

    // Step 1: the boxes of both sides. Sides that are far from each other are
    // done with here.
    std::vector<Box<dim>> boxes;
    boxes.reserve(searched_p.size());
    for (const auto &f : searched_p)
      boxes.push_back(box_around(f));
    const Box<dim>                                 all = box_around(boxes);
    std::vector<std::pair<unsigned int, Box<dim>>> near;
    for (unsigned int f = 0; f < secondary.n_own; ++f)
      {
        const Box<dim> box = region_of(f, searched_s[f], motion);
        if (intersect(box, all))
          near.emplace_back(f, box);
      }
    if (near.empty())
      return found;

    // Step 2: the pairs of facets.
    const BroadPhase<dim> broad_phase(boxes);
    const PairFilter<dim> filter(secondary,
                                 primary,
                                 kernel.options.zero_cosine,
                                 kernel.options.ceiling);
    for (const auto &[f, box] : near)
      for (const unsigned int p : broad_phase.find(box))
        if (filter.may_touch(f, p))
          found.emplace_back(f, p);
    return found;
  }


  template <int dim>
  Box<dim>
  ContactSweep<dim>::swept_region(const unsigned int f,
                                  const Facet<dim>  &moved) const
  {
    Box<dim> box = box_around(secondary.facets[f].current, moved);
    inflate(box, surface_offset);
    return box;
  }


  template <int dim>
  std::vector<Box<dim>>
  ContactSweep<dim>::swept_regions(const std::vector<Facet<dim>> &moved) const
  {
    std::vector<Box<dim>> result;
    for (unsigned int f = 0; f < secondary.n_own; ++f)
      result.push_back(swept_region(f, moved[f]));
    return result;
  }


  template <int dim>
  double
  ContactSweep<dim>::safe_step(const std::vector<Facet<dim>> &moved_s,
                               const std::vector<Facet<dim>> &moved_p) const
  {
    double step = 1.;
    if (secondary.n_own == 0 || moved_p.empty())
      return step;

    std::vector<Box<dim>> boxes;
    for (unsigned int p = 0; p < moved_p.size(); ++p)
      boxes.push_back(box_around(primary.facets[p].current, moved_p[p]));
    const Box<dim>                                 all = box_around(boxes);
    std::vector<std::pair<unsigned int, Box<dim>>> near;
    for (unsigned int f = 0; f < secondary.n_own; ++f)
      {
        const Box<dim> box = swept_region(f, moved_s[f]);
        if (intersect(box, all))
          near.emplace_back(f, box);
      }
    if (near.empty())
      return step;

    const BroadPhase<dim> broad_phase(boxes);
    const PairFilter<dim> filter(secondary,
                                 primary,
                                 kernel.options.zero_cosine,
                                 kernel.options.ceiling);
    for (const auto &[f, box] : near)
      {
        const ContactFacet<dim> &facet = secondary.facets[f];
        const Tensor<1, dim>     w     = centre_normal(facet.current);
        const Tensor<1, dim>     n     = w / w.norm();
        double advance                 = std::numeric_limits<double>::lowest();
        double front                   = advance;
        for (unsigned int a = 0; a < facet.current.n_vertices; ++a)
          {
            front = std::max(front, n * facet.current.x[a]);
            advance =
              std::max(advance, n * (moved_s[f].x[a] - facet.current.x[a]));
          }
        for (const unsigned int p : broad_phase.find(box))
          {
            if (!filter.face_each_other(f, p))
              continue;
            const Facet<dim> &other    = primary.facets[p].current;
            double            gap      = std::numeric_limits<double>::max();
            double            approach = gap;
            for (unsigned int a = 0; a < other.n_vertices; ++a)
              {
                gap = std::min(gap, n * other.x[a] - front);
                approach =
                  std::min(approach, n * (moved_p[p].x[a] - other.x[a]));
              }
            gap -= facet.surface_offset + primary.facets[p].surface_offset;
            const double closing = advance - approach;
            const double allowed = std::max(gap, 0.) + safe_share * longest(f);
            if (gap > -reach(f) - diameter(other) && closing > allowed)
              step = std::min(step, allowed / closing);
          }
      }
    return step;
  }


  template <int dim>
  double
  ContactSweep<dim>::safe_step_to_obstacle(const std::vector<Facet<dim>> &moved,
                                           const RigidMotion<dim> &motion) const
  {
    double step = 1.;
    for (unsigned int f = 0; f < secondary.n_own; ++f)
      {
        const Facet<dim>         &facet = secondary.facets[f].current;
        const SecondaryFrame<dim> frame(facet);
        // towards the body, that moves itself
        double advance = 0.;
        for (unsigned int a = 0; a < facet.n_vertices; ++a)
          advance =
            std::max(advance,
                     frame.normal *
                       (moved[f].x[a] -
                        motion.place(obstacle->motion.origin(facet.x[a]))));
        const double allowed = safe_share * longest(f);
        if (advance <= allowed ||
            obstacle->is_far(centre(facet), frame.diameter + advance))
          continue;
        double gap = std::numeric_limits<double>::max();
        for (const auto &point : kernel.fixed_points(facet.n_vertices))
          if (const auto found =
                hit(frame, point.first, 0, far_of(frame) + advance))
            gap =
              std::min(gap, -found->depth - secondary.facets[f].surface_offset);
        if (advance > std::max(gap, 0.) + allowed)
          step = std::min(step, (std::max(gap, 0.) + allowed) / advance);
      }
    return step;
  }


  template double
  ContactSweep<2>::longest(const unsigned int) const;
  template double
  ContactSweep<2>::reach(const unsigned int) const;
  template bool
  ContactSweep<2>::needs_search() const;
  template void
  ContactSweep<2>::search();
  template double
  ContactSweep<2>::motion_of(const double) const;
  template std::vector<std::pair<unsigned int, unsigned int>>
  ContactSweep<2>::candidates_after(const double) const;
  template Box<2>
  ContactSweep<2>::region_of(const unsigned int,
                             const Facet<2> &,
                             const double) const;
  template std::vector<Box<2>>
  ContactSweep<2>::regions(const double) const;
  template std::vector<std::pair<unsigned int, unsigned int>>
  ContactSweep<2>::find_pairs(const double) const;
  template Box<2>
  ContactSweep<2>::swept_region(const unsigned int, const Facet<2> &) const;
  template std::vector<Box<2>>
  ContactSweep<2>::swept_regions(const std::vector<Facet<2>> &) const;
  template double
  ContactSweep<2>::safe_step(const std::vector<Facet<2>> &,
                             const std::vector<Facet<2>> &) const;
  template double
  ContactSweep<2>::safe_step_to_obstacle(const std::vector<Facet<2>> &,
                                         const RigidMotion<2> &) const;
  template double
  ContactSweep<3>::longest(const unsigned int) const;
  template double
  ContactSweep<3>::reach(const unsigned int) const;
  template bool
  ContactSweep<3>::needs_search() const;
  template void
  ContactSweep<3>::search();
  template double
  ContactSweep<3>::motion_of(const double) const;
  template std::vector<std::pair<unsigned int, unsigned int>>
  ContactSweep<3>::candidates_after(const double) const;
  template Box<3>
  ContactSweep<3>::region_of(const unsigned int,
                             const Facet<3> &,
                             const double) const;
  template std::vector<Box<3>>
  ContactSweep<3>::regions(const double) const;
  template std::vector<std::pair<unsigned int, unsigned int>>
  ContactSweep<3>::find_pairs(const double) const;
  template Box<3>
  ContactSweep<3>::swept_region(const unsigned int, const Facet<3> &) const;
  template std::vector<Box<3>>
  ContactSweep<3>::swept_regions(const std::vector<Facet<3>> &) const;
  template double
  ContactSweep<3>::safe_step(const std::vector<Facet<3>> &,
                             const std::vector<Facet<3>> &) const;
  template double
  ContactSweep<3>::safe_step_to_obstacle(const std::vector<Facet<3>> &,
                                         const RigidMotion<3> &) const;
} // namespace MortarContact
