// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/laws/initial_penetration.h>
#include <mortar_contact/mortar/contact_sweep.h>
#include <mortar_contact/search/broad_phase.h>
#include <mortar_contact/search/pair_filter.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace MortarContact
{
  namespace
  {
    /// Margin of the search in mean diameters of the secondary facets: larger
    /// means rarer searches, but more candidates and more matrix entries.
    constexpr double margin_share = 0.25;

    /// Obstacles are looked for no farther than this times what a facet
    /// reaches, also where any depth counts: Newton's method needs a scale.
    constexpr double out_of_sight = 1e3;

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
  ContactSweep<dim>::ContactSweep(const Skin<dim>     &secondary,
                                  const Skin<dim>     &primary,
                                  const Obstacle<dim> *obstacle,
                                  const PressureLaw   &law,
                                  const FrictionLaw   *friction,
                                  const KernelOptions &options,
                                  const double         weight)
    : secondary(secondary)
    , primary(primary)
    , obstacle(obstacle)
    , law(law)
    , kernel(law, friction, options)
    , weight(weight)
    , margin(margin_share * secondary.sizes.mean_diameter)
    , surface_offset(secondary.sizes.largest_offset +
                     primary.sizes.largest_offset)
  {
    Assert(obstacle == nullptr ||
             options.integration.rule != Integration::Rule::segments,
           ExcMessage("A surface without facets has no segments."));
    if (friction != nullptr)
      {
        history.elastic_slip.resize(secondary.n_own);
        history.sliding.resize(secondary.n_own, VertexValues<dim>{});
        store_before();
      }
  }


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
  SecondaryState<dim>
  ContactSweep<dim>::state_of(const unsigned int f, FacetSlip<dim> &slip) const
  {
    SecondaryState<dim> state;
    const unsigned int  n = secondary.facets[f].current.n_vertices;
    if (!history.level.empty())
      {
        state.share = last_share;
        state.level = extrapolate_to_vertices<dim>(n, history.level[f]);
      }
    if (!augmentation.empty())
      state.augmentation = extrapolate_to_vertices<dim>(n, augmentation[f]);
    if (kernel.point.has_friction())
      {
        slip           = slips[f];
        slip.share     = history.share;
        slip.time_step = last_time_step;
        state.slip     = &slip;
      }
    return state;
  }


  template <int dim>
  bool
  ContactSweep<dim>::has_no_contact(const unsigned int f) const
  {
    return is_released(f) || (!history.tied.empty() && history.tied[f]);
  }


  template <int dim>
  const Facet<dim> *
  ContactSweep<dim>::primary_before(const unsigned int p) const
  {
    return history.before[1].empty() ? nullptr : &history.before[1][p];
  }


  template <int dim>
  std::optional<typename PairKernel<dim>::Hit>
  ContactSweep<dim>::hit(const SecondaryFrame<dim> &frame,
                         const PlanePoint<dim>     &xi,
                         const unsigned int         p,
                         const double               range) const
  {
    if (obstacle == nullptr)
      return kernel.hit(frame, xi, primary.facets[p]);
    const Tensor<1, dim> x =
      interpolate(frame.facet, shape_values<dim>(frame.facet.n_vertices, xi));
    const auto surface = obstacle->meet(x, frame.normal, range);
    if (!surface)
      return {};
    return typename PairKernel<dim>::Hit{PlanePoint<dim>(),
                                         frame.normal * (x - surface->x),
                                         surface};
  }


  template <int dim>
  PrimaryPoint<dim>
  ContactSweep<dim>::primary_point(
    const unsigned int                   p,
    const typename PairKernel<dim>::Hit &at) const
  {
    if (!at.surface)
      return kernel.primary_point(primary.facets[p], primary_before(p), at.eta);
    PrimaryPoint<dim> point;
    static_cast<SurfacePoint<dim> &>(point) = *at.surface;
    return point;
  }


  template <int dim>
  std::vector<unsigned int>
  ContactSweep<dim>::candidates_of(const unsigned int f,
                                   unsigned int      &next) const
  {
    std::vector<unsigned int> near;
    while (next < pairs.size() && pairs[next].first < f)
      ++next;
    for (; next < pairs.size() && pairs[next].first == f; ++next)
      near.push_back(pairs[next].second);
    return near;
  }


  template <int dim>
  bool
  ContactSweep<dim>::is_released(const unsigned int f) const
  {
    return !history.released.empty() && history.released[f];
  }


  template <int dim>
  void
  ContactSweep<dim>::count(const PairBlock<dim> &block)
  {
    ++(block.is_active()    ? last_counts.active :
       (block.n_points > 0) ? last_counts.open :
                              last_counts.apart);
    last_counts.degenerate += block.is_degenerate;
    last_counts.beyond += block.n_beyond > 0;
    last_counts.smallest_gap =
      std::min(last_counts.smallest_gap, block.smallest_gap);
    last_counts.largest_gap =
      std::max(last_counts.largest_gap, block.largest_gap);
    last_counts.overlap = std::max(last_counts.overlap, block.overlap);
  }


  template <int dim>
  void
  ContactSweep<dim>::evaluate(const double share,
                              const double time_step,
                              const bool   with_tangent)
  {
    active.clear();
    new_aside.clear();
    last_counts    = {};
    last_share     = share;
    last_time_step = time_step;
    if (kernel.options.integration.rule != Integration::Rule::segments)
      {
        evaluate_points(with_tangent);
        return;
      }

    unsigned int next = 0;
    for (unsigned int f = 0; f < secondary.n_own && next < pairs.size(); ++f)
      {
        if (pairs[next].first != f)
          continue;
        const ContactFacet<dim>  &facet = secondary.facets[f];
        const SecondaryFrame<dim> frame(facet.current);
        FacetSlip<dim>            slip;
        const SecondaryState<dim> state   = state_of(f, slip);
        const bool                dropped = has_no_contact(f);
        for (; next < pairs.size() && pairs[next].first == f; ++next)
          {
            const unsigned int p = pairs[next].second;
            active.push_back({f, p, {}});
            PairBlock<dim> &block = active.back().block;
            if (!dropped)
              kernel.evaluate_segments(frame,
                                       facet,
                                       state,
                                       primary.facets[p],
                                       primary_before(p),
                                       weight,
                                       with_tangent,
                                       block);
            count(block);
            if (!block.is_active())
              active.pop_back();
            else if (with_tangent)
              kernel.finish(block);
          }
      }
  }


  template <int dim>
  void
  ContactSweep<dim>::evaluate_points(const bool with_tangent)
  {
    unsigned int next = 0;
    for (unsigned int f = 0; f < secondary.n_own && next < pairs.size(); ++f)
      {
        const std::vector<unsigned int> near = candidates_of(f, next);
        if (near.empty() || has_no_contact(f))
          continue;
        const ContactFacet<dim> &facet = secondary.facets[f];
        if (obstacle != nullptr && !may_meet_obstacle(f))
          continue;
        const SecondaryFrame<dim> frame(facet.current);
        FacetSlip<dim>            slip;
        const SecondaryState<dim> state = state_of(f, slip);

        const std::size_t first_active = active.size();
        for (const unsigned int p : near)
          active.push_back({f, p, {}});

        // each point belongs to the nearest facet that it hits
        for (const auto &[xi, w] :
             kernel.fixed_points(facet.current.n_vertices))
          {
            std::optional<typename PairKernel<dim>::Hit> best;
            unsigned int                                 best_pair = 0;
            for (unsigned int k = 0; k < near.size(); ++k)
              {
                const auto found = hit(frame, xi, near[k], far_of(frame));
                if (found &&
                    (!best || std::abs(found->depth) < std::abs(best->depth)))
                  {
                    best      = found;
                    best_pair = k;
                  }
              }
            if (best)
              kernel.add_fixed_point(frame,
                                     facet,
                                     state,
                                     primary_point(near[best_pair], *best),
                                     xi,
                                     weight * w,
                                     with_tangent,
                                     active[first_active + best_pair].block);
          }

        std::size_t kept = first_active;
        for (std::size_t k = first_active; k < active.size(); ++k)
          {
            PairBlock<dim> &block = active[k].block;
            count(block);
            if (!block.is_active())
              continue;
            if (with_tangent)
              kernel.finish(block);
            if (kept != k)
              active[kept] = active[k];
            ++kept;
          }
        active.resize(kept);
      }
  }


  template <int dim>
  bool
  ContactSweep<dim>::may_meet_obstacle(const unsigned int f) const
  {
    const Facet<dim> &facet = secondary.facets[f].current;
    return !obstacle->is_far(centre(facet), diameter(facet) + last_reach);
  }


  template <int dim>
  std::optional<typename ContactSweep<dim>::Depth>
  ContactSweep<dim>::depth_at(const SecondaryFrame<dim>       &frame,
                              const PlanePoint<dim>           &xi,
                              const unsigned int               f,
                              const std::vector<unsigned int> &among,
                              const double                     deepest) const
  {
    const double         far = out_of_sight * far_of(frame);
    std::optional<Depth> nearest;
    // Back faces of the primary that the point has passed, see below.
    double nearest_back = std::numeric_limits<double>::max();
    for (const unsigned int p : among)
      {
        const auto found =
          hit(frame, xi, p, std::min(far, std::max(deepest, far_of(frame))));
        if (!found)
          continue;
        if (obstacle != nullptr)
          {
            const ContactFacet<dim> &s = secondary.facets[f];
            const auto   N = shape_values<dim>(s.current.n_vertices, xi);
            const double d = found->depth + s.surface_offset;
            if (d <= deepest)
              nearest =
                Depth{d,
                      kernel.point.combine(PairAlgebra::dot<dim>(N,
                                                                 s.compliance),
                                           PairAlgebra::dot<dim>(N, s.length),
                                           0.,
                                           0.),
                      p,
                      *found};
            continue;
          }
        const double d = found->depth + secondary.facets[f].surface_offset +
                         primary.facets[p].surface_offset;
        const Tensor<1, dim> w      = centre_normal(primary.facets[p].current);
        const double         cosine = -(frame.normal * w) / w.norm();
        if (cosine < -kernel.options.zero_cosine && d > 0.)
          nearest_back = std::min(nearest_back, d);
        if (cosine > kernel.options.zero_cosine && d <= deepest &&
            (!nearest || std::abs(d) < std::abs(nearest->depth)))
          nearest = Depth{d,
                          kernel.stiffness(secondary.facets[f],
                                           xi,
                                           primary.facets[p],
                                           found->eta),
                          p,
                          *found};
      }
    // Between the surface and a point inside lies no back face: a point that
    // has passed one stands behind a wall, it does not penetrate it.
    if (nearest && nearest_back < nearest->depth)
      return {};
    return nearest;
  }


  template <int dim>
  typename ContactSweep<dim>::FacetDepths
  ContactSweep<dim>::depths_of(const unsigned int               f,
                               const std::vector<unsigned int> &among,
                               const double                     deepest) const
  {
    // Overlaps of a small part of the facet, beyond its points, are looked for
    // at this share of the way from each corner to the centre.
    constexpr double inside_corner = 1e-3;
    // Extrapolated depths may miss those at corners by this share of the
    // deepest.
    constexpr double corner_tolerance = 0.5;

    const Facet<dim>         &facet = secondary.facets[f].current;
    const unsigned int        n     = facet.n_vertices;
    const SecondaryFrame<dim> frame(facet);
    const auto                points = material_points<dim>(n);
    FacetDepths               result;
    const auto                keep_deepest = [&](const PlanePoint<dim>      &xi,
                                  const std::optional<Depth> &d) {
      if (d && (!result.deepest || d->depth > result.deepest->depth))
        {
          result.deepest = d;
          result.position = interpolate(facet, shape_values<dim>(n, xi));
        }
    };
    const auto overlaps = [](const std::optional<Depth> &d) {
      return d && d->depth > 0.;
    };

    bool sees_gaps = false;
    for (const PlanePoint<dim> &xi : points)
      {
        result.at_points.push_back(depth_at(frame, xi, f, among, deepest));
        keep_deepest(xi, result.at_points.back());
        if (result.at_points.back() && !overlaps(result.at_points.back()))
          sees_gaps = true;
      }
    const bool points_overlap = overlaps(result.deepest);
    result.of_corners_only    = sees_gaps && !points_overlap;

    // Step 1: the corners of a facet that is partly open, or seems to be open.
    std::array<PlanePoint<dim>, max_vertices<dim>>      at_corner;
    std::array<std::optional<Depth>, max_vertices<dim>> corners;
    double at_deepest = result.deepest ? result.deepest->depth : 0.;
    if (sees_gaps || !points_overlap)
      for (unsigned int a = 0; a < n; ++a)
        {
          const PlanePoint<dim> corner = reference_vertex<dim>(n, a);
          at_corner[a] =
            corner + inside_corner * (reference_centre<dim>(n) - corner);
          corners[a] = depth_at(frame, at_corner[a], f, among, deepest);
          if (corners[a])
            at_deepest = std::max(at_deepest, corners[a]->depth);
          if (!points_overlap)
            keep_deepest(at_corner[a], corners[a]);
        }

    // Step 2: a point that sees nothing goes with the deepest.
    for (std::optional<Depth> &d : result.at_points)
      if (!d)
        d = result.deepest;
    if (!overlaps(result.deepest) || !sees_gaps)
      return result;

    // Step 3: gaps may lie in front of another part of the surface, far beyond
    // the overlap, and tilt what is extrapolated from them. Does it agree with
    // what the corners see?
    VertexValues<dim> depths{};
    for (unsigned int q = 0; q < n; ++q)
      depths[q] = result.at_points[q]->depth;
    const VertexValues<dim> at_vertices =
      extrapolate_to_vertices<dim>(n, depths);
    bool agrees = true;
    for (unsigned int a = 0; a < n; ++a)
      {
        const double by_points =
          PairAlgebra::dot<dim>(shape_values<dim>(n, at_corner[a]),
                                at_vertices);
        agrees =
          agrees &&
          (corners[a] ? std::abs(std::max(by_points, 0.) -
                                 std::max(corners[a]->depth, 0.)) <=
                          corner_tolerance * at_deepest :
                        by_points <= (1. + corner_tolerance) * at_deepest);
      }
    if (agrees)
      return result;

    // Step 4: if not, levels follow the corners, and points that overlap; no
    // farther below zero than the deepest is above, and nowhere above it.
    VertexValues<dim> by_corners{};
    for (unsigned int a = 0; a < n; ++a)
      by_corners[a] =
        std::clamp(corners[a] ? corners[a]->depth : at_vertices[a],
                   -at_deepest,
                   at_deepest);
    const auto at_point = [&](const unsigned int       q,
                              const VertexValues<dim> &by_vertices) {
      return PairAlgebra::dot<dim>(shape_values<dim>(n, points[q]),
                                   by_vertices);
    };
    for (unsigned int q = 0; q < n; ++q)
      depths[q] = (depths[q] > 0.) ?
                    std::max(depths[q], at_point(q, by_corners)) :
                    at_point(q, by_corners);
    VertexValues<dim> levels = extrapolate_to_vertices<dim>(n, depths);
    for (unsigned int a = 0; a < n; ++a)
      levels[a] = std::min(levels[a], at_deepest);
    for (unsigned int q = 0; q < n; ++q)
      result.at_points[q]->depth = at_point(q, levels);
    return result;
  }


  template <int dim>
  std::array<double, 2>
  ContactSweep<dim>::initial_ranges(const unsigned int         f,
                                    const SecondaryFrame<dim> &frame,
                                    const InitialTreatment    &treatment) const
  {
    // Penetrations beyond what is treated must be found to be reported.
    constexpr double look_deeper = 2.;
    // So many facets deep, where nothing of the same surface can be meant: a
    // smooth body knows what is inside; between two surfaces it is only told.
    const double facets_deep = (obstacle != nullptr)    ? 20. :
                               (&secondary != &primary) ? 5. :
                                                          0.;
    const double l           = longest(f);
    // at least as deep as contact will act
    const double near_range =
      std::max(kernel.options.ceiling * l,
               look_deeper * ((treatment.deepest > 0.) ?
                                treatment.deepest :
                                treatment.largest_share * l));
    return {{near_range, std::max(near_range, facets_deep * far_of(frame))}};
  }


  template <int dim>
  Box<dim>
  ContactSweep<dim>::initial_region(const unsigned int      f,
                                    const InitialTreatment &treatment) const
  {
    const Facet<dim>         &facet = secondary.facets[f].current;
    const SecondaryFrame<dim> frame(facet);
    const double              range = initial_ranges(f, frame, treatment)[1];
    Box<dim>                  box   = box_around(facet);
    for (unsigned int a = 0; a < facet.n_vertices; ++a)
      for (const double by : {-range, longest(f)})
        extend(box, Tensor<1, dim>(facet.x[a] + by * frame.normal));
    inflate(box, margin + surface_offset);
    return box;
  }


  template <int dim>
  std::vector<Box<dim>>
  ContactSweep<dim>::initial_regions(const InitialTreatment &treatment) const
  {
    std::vector<Box<dim>> result;
    for (unsigned int f = 0; f < secondary.n_own; ++f)
      result.push_back(initial_region(f, treatment));
    return result;
  }


  template <int dim>
  InitialFindings<dim>
  ContactSweep<dim>::detect_initial(const InitialTreatment &treatment)
  {
    std::vector<Box<dim>> boxes;
    for (const auto &p : primary.facets)
      boxes.push_back(box_around(p.current));
    const BroadPhase<dim> broad_phase(boxes);
    const PairFilter<dim> filter(secondary,
                                 primary,
                                 kernel.options.zero_cosine,
                                 kernel.options.ceiling);

    InitialFindings<dim> findings;
    history.level.clear();
    history.released.clear();
    for (unsigned int f = 0; f < secondary.n_own; ++f)
      {
        // Step 1: the primary facets around.
        const ContactFacet<dim>  &facet = secondary.facets[f];
        const SecondaryFrame<dim> frame(facet.current);
        const auto [near_range, range] = initial_ranges(f, frame, treatment);
        std::vector<unsigned int> near =
          broad_phase.find(initial_region(f, treatment));
        near.erase(std::remove_if(near.begin(),
                                  near.end(),
                                  [&](const unsigned int p) {
                                    return filter.are_neighbours(f, p);
                                  }),
                   near.end());
        if (obstacle != nullptr)
          near.assign(facet.compliance[0] > 0. ? 1 : 0, 0);
        if (near.empty())
          continue;

        // Step 2: how deep? Where nothing is seen, look deeper, to tell.
        FacetDepths depths     = depths_of(f, near, near_range);
        const auto  penetrates = [&]() {
          return depths.deepest && depths.deepest->depth > 0.;
        };
        const bool is_out_of_sight = !penetrates();
        if (is_out_of_sight)
          depths = depths_of(f, near, range);
        if (!penetrates())
          continue;
        const Depth &deepest = *depths.deepest;

        // Step 3: too deep to be treated?
        const double limit =
          (treatment.deepest > 0.) ?
            treatment.deepest :
            treatment.largest_share * deepest.stiffness.length;
        // Contact of a facet that is open elsewhere is not given up for its
        // corners, where a treatment takes the force off them.
        if (is_out_of_sight || (deepest.depth > limit &&
                                !(depths.of_corners_only && treatment.store &&
                                  treatment.deepest == 0.)))
          {
            ++findings.n_too_deep;
            if (deepest.depth > findings.too_deep)
              {
                findings.too_deep          = deepest.depth;
                findings.too_deep_length   = deepest.stiffness.length;
                findings.too_deep_facet    = f;
                findings.too_deep_position = depths.position;
              }
            if (!is_out_of_sight || obstacle != nullptr)
              {
                if (history.released.empty())
                  history.released.resize(secondary.n_own, false);
                history.released[f] = true;
              }
            continue;
          }

        ++findings.n_facets;
        if (deepest.depth > findings.depth)
          {
            findings.depth    = deepest.depth;
            findings.length   = deepest.stiffness.length;
            findings.facet    = f;
            findings.position = depths.position;
          }
        if (!treatment.store)
          continue;

        // Step 4: keep the levels.
        if (history.level.empty())
          history.level.resize(secondary.n_own, VertexValues<dim>{});
        for (unsigned int q = 0; q < depths.at_points.size(); ++q)
          {
            const Depth &at = *depths.at_points[q];
            const double remaining =
              at.stiffness.length *
              law.inverse(treatment.remaining_pressure / at.stiffness.modulus);
            history.level[f][q] =
              (at.depth > 0.) ? at.depth - remaining : at.depth;
          }
      }
    restore(history);
    return findings;
  }


  template <int dim>
  std::vector<unsigned int>
  ContactSweep<dim>::too_deep(const double largest_share) const
  {
    std::vector<unsigned int> facets;
    for (const ActivePair &pair : active)
      if (pair.block.relative_penetration > largest_share)
        if (facets.empty() || facets.back() != pair.secondary)
          facets.push_back(pair.secondary);
    return facets;
  }


  template <int dim>
  void
  ContactSweep<dim>::update_slip()
  {
    if (!kernel.point.has_friction())
      return;
    unsigned int next = 0;
    for (unsigned int f = 0; f < secondary.n_own; ++f)
      {
        const std::vector<unsigned int> near = candidates_of(f, next);
        const unsigned int        n = secondary.facets[f].current.n_vertices;
        FacetSlip<dim>            slip;
        const auto                state = state_of(f, slip);
        const SecondaryFrame<dim> frame(secondary.facets[f].current);
        const auto                points = material_points<dim>(n);
        history.elastic_slip[f]          = {};
        if (near.empty() || has_no_contact(f))
          continue;
        for (unsigned int q = 0; q < points.size(); ++q)
          {
            const auto at = depth_at(frame, points[q], f, near, reach(f));
            if (!at)
              continue;
            const PointState<dim> s =
              kernel.point.state_at(frame,
                                    secondary.facets[f],
                                    state,
                                    primary_point(at->primary, at->hit),
                                    points[q]);
            history.elastic_slip[f][q] = s.elastic_slip;
            history.sliding[f][q] += s.slip;
          }
      }
    store_before();
  }


  template <int dim>
  double
  ContactSweep<dim>::far_of(const SecondaryFrame<dim> &frame) const
  {
    // gaps matter too: as far as a facet is large
    return std::max(last_reach, frame.diameter);
  }


  template <int dim>
  std::vector<double>
  ContactSweep<dim>::depths_at_points(const unsigned int f,
                                      unsigned int      &next) const
  {
    const std::vector<unsigned int> near = candidates_of(f, next);
    const unsigned int              n = secondary.facets[f].current.n_vertices;
    const auto                      points = material_points<dim>(n);
    std::vector<double>             depths(points.size(),
                               std::numeric_limits<double>::lowest());
    if (near.empty() || has_no_contact(f))
      return depths;
    FacetSlip<dim>            slip;
    const SecondaryState<dim> state = state_of(f, slip);
    const SecondaryFrame<dim> frame(secondary.facets[f].current);
    for (unsigned int q = 0; q < points.size(); ++q)
      if (const auto at = depth_at(frame, points[q], f, near, reach(f)))
        depths[q] = kernel.point
                      .state_at(frame,
                                secondary.facets[f],
                                state,
                                primary_point(at->primary, at->hit),
                                points[q])
                      .penetration;
    return depths;
  }


  template <int dim>
  double
  ContactSweep<dim>::penetration() const
  {
    double       largest_depth = 0.;
    unsigned int next          = 0;
    for (unsigned int f = 0; f < secondary.n_own; ++f)
      {
        const std::vector<double> depths = depths_at_points(f, next);
        for (unsigned int q = 0; q < depths.size(); ++q)
          if ((augmentation.empty() ? 0. : augmentation[f][q]) + depths[q] > 0.)
            largest_depth = std::max(largest_depth, std::abs(depths[q]));
      }
    return largest_depth;
  }


  template <int dim>
  void
  ContactSweep<dim>::augment()
  {
    if (augmentation.empty())
      augmentation.resize(secondary.n_own, VertexValues<dim>{});
    unsigned int next = 0;
    for (unsigned int f = 0; f < secondary.n_own; ++f)
      {
        const std::vector<double> depths = depths_at_points(f, next);
        VertexValues<dim>         A      = {};
        for (unsigned int q = 0; q < depths.size(); ++q)
          A[q] = std::max(0., augmentation[f][q] + depths[q]);
        augmentation[f] = A;
      }
  }


  template <int dim>
  void
  ContactSweep<dim>::commit(const bool                       track,
                            const std::vector<unsigned int> &released)
  {
    commit_pairs_aside();
    update_slip();
    history.augmentation = augmentation;
    history.share        = last_share;
    if (history.level.empty() && history.released.empty() && released.empty())
      return;

    // A facet has opened when nothing presses on it any more. Levels are
    // bilinear, depths of curved surfaces are not: at rest some points press
    // and others are open, and levels that followed those would creep.
    const bool        tracks = track && !history.level.empty();
    std::vector<char> presses(tracks ? secondary.n_own : 0, 0);
    if (tracks)
      for (const ActivePair &pair : active)
        presses[pair.secondary] = 1;

    unsigned int next = 0;
    for (unsigned int f = 0; f < secondary.n_own; ++f)
      {
        std::vector<unsigned int> near = candidates_of(f, next);

        const bool follows = tracks && !presses[f];
        if (!follows && !is_released(f))
          continue;

        // a released facet may have sunk out of reach: look at everything
        if (is_released(f))
          {
            near.resize(obstacle != nullptr ? 1 : primary.facets.size());
            std::iota(near.begin(), near.end(), 0u);
          }
        const FacetDepths depths =
          depths_of(f,
                    near,
                    is_released(f) ? std::numeric_limits<double>::max() :
                                     reach(f));
        if (follows)
          for (unsigned int q = 0; q < depths.at_points.size(); ++q)
            {
              // out of sight is open
              const std::optional<Depth> &d = depths.at_points[q];
              history.level[f][q] =
                std::min(history.level[f][q], d ? d->depth : 0.);
            }
        const bool is_open = !depths.deepest || depths.deepest->depth <= 0.;
        if (is_released(f) && is_open)
          history.released[f] = false;
      }

    if (!released.empty())
      {
        if (history.released.empty())
          history.released.resize(secondary.n_own, false);
        for (const unsigned int f : released)
          history.released[f] = true;
        searched_s.clear(); // from now on they look everywhere: search
      }
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


  template class ContactSweep<2>;
  template class ContactSweep<3>;
} // namespace MortarContact
