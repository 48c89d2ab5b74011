// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/mortar/contact_sweep.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
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


  template class ContactSweep<2>;
  template class ContactSweep<3>;
} // namespace MortarContact
