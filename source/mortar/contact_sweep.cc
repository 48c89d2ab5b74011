// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/laws/initial_penetration.h>
#include <mortar_contact/mortar/contact_sweep.h>
#include <mortar_contact/search/broad_phase.h>
#include <mortar_contact/search/pair_filter.h>

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

    /// A motion may close the gap and penetrate by this share of l more.
    constexpr double safe_share = 0.5;

    template <int dim>
    std::vector<Facet<dim>>
    current_facets(const Skin<dim> &skin)
    {
      std::vector<Facet<dim>> result;
      result.reserve(skin.facets.size());
      for (const auto &f : skin.facets)
        result.push_back(f.current);
      return result;
    }

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
                                  const PressureLaw   &law,
                                  const KernelOptions &options,
                                  const double         weight)
    : secondary(secondary)
    , primary(primary)
    , law(law)
    , kernel(law, options)
    , weight(weight)
  {
    double sum = 0.;
    for (unsigned int f = 0; f < secondary.facets.size(); ++f)
      {
        sum += diameter(secondary.facets[f].reference);
        if (secondary.is_owned[f])
          owned.push_back(f);
      }
    for (const auto &f : primary.facets)
      {
        largest_length_p = std::max(largest_length_p, largest(f));
        largest_compliance_p =
          std::max(largest_compliance_p,
                   *std::max_element(f.compliance.begin(),
                                     f.compliance.begin() +
                                       f.current.n_vertices));
      }
    if (!secondary.facets.empty() && !primary.facets.empty())
      surface_offset = std::abs(secondary.facets[0].surface_offset) +
                       std::abs(primary.facets[0].surface_offset);
    margin =
      margin_share * sum / std::max<std::size_t>(1, secondary.facets.size());
  }


  template <int dim>
  double
  ContactSweep<dim>::longest(const unsigned int f) const
  {
    const ContactFacet<dim> &facet = secondary.facets[f];
    const double             l_s   = largest(facet);
    if (kernel.options.stiffness_side == StiffnessSide::secondary ||
        largest_length_p <= l_s)
      return l_s;
    // grows with the primary's share
    const double c_s =
      *std::max_element(facet.compliance.begin(),
                        facet.compliance.begin() + facet.current.n_vertices);
    return in_series(c_s, l_s, largest_compliance_p, largest_length_p).length;
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

    std::vector<Box<dim>> boxes;
    boxes.reserve(searched_p.size());
    for (const auto &f : searched_p)
      boxes.push_back(box_around(f));
    const BroadPhase<dim> broad_phase(boxes);

    const PairFilter<dim> filter(secondary,
                                 primary,
                                 kernel.options.zero_cosine);
    pairs.clear();
    for (const unsigned int f : owned)
      {
        // the box of the facet, swept inwards over the depth that counts
        Box<dim>             box = box_around(searched_s[f]);
        const Tensor<1, dim> w   = centre_normal(searched_s[f]);
        for (unsigned int a = 0; a < searched_s[f].n_vertices; ++a)
          extend(box,
                 Tensor<1, dim>(searched_s[f].x[a] - reach(f) / w.norm() * w));
        inflate(box, margin + surface_offset);
        for (const unsigned int p : broad_phase.find(box))
          if (filter.may_touch(f, p))
            pairs.emplace_back(f, p);
      }
  }


  template <int dim>
  FacetOffset<dim>
  ContactSweep<dim>::offset_of(const unsigned int o, const double share) const
  {
    FacetOffset<dim> offset;
    if (!history.level.empty() && share > 0.)
      {
        offset.share = share;
        offset.level = extrapolate_to_vertices<dim>(
          secondary.facets[owned[o]].current.n_vertices, history.level[o]);
      }
    return offset;
  }


  template <int dim>
  bool
  ContactSweep<dim>::is_released(const unsigned int o) const
  {
    return !history.released.empty() && history.released[o];
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
    last_counts.overlap = std::max(last_counts.overlap, block.overlap);
  }


  template <int dim>
  void
  ContactSweep<dim>::evaluate(const double share, const bool with_tangent)
  {
    active.clear();
    last_counts = {};
    if (kernel.options.integration.rule == Integration::Rule::points)
      {
        evaluate_points(share, with_tangent);
        return;
      }

    unsigned int next = 0;
    for (unsigned int o = 0; o < owned.size() && next < pairs.size(); ++o)
      {
        if (pairs[next].first != owned[o])
          continue;
        const unsigned int        f     = owned[o];
        const ContactFacet<dim>  &facet = secondary.facets[f];
        const SecondaryFrame<dim> frame(facet.current);
        const FacetOffset<dim>    offset  = offset_of(o, share);
        const bool                dropped = is_released(o);
        for (; next < pairs.size() && pairs[next].first == f; ++next)
          {
            const unsigned int p = pairs[next].second;
            active.push_back({f, p, {}});
            PairBlock<dim> &block = active.back().block;
            if (!dropped)
              kernel.evaluate_segments(frame,
                                       facet,
                                       offset,
                                       primary.facets[p],
                                       weight,
                                       with_tangent,
                                       block);
            count(block);
            if (block.is_active())
              {
                if (with_tangent)
                  kernel.finish(block);
              }
            else
              active.pop_back();
          }
      }
  }


  template <int dim>
  void
  ContactSweep<dim>::evaluate_points(const double share,
                                     const bool   with_tangent)
  {
    unsigned int next = 0;
    for (unsigned int o = 0; o < owned.size() && next < pairs.size(); ++o)
      {
        if (pairs[next].first != owned[o])
          continue;
        const unsigned int        f     = owned[o];
        const ContactFacet<dim>  &facet = secondary.facets[f];
        const SecondaryFrame<dim> frame(facet.current);
        const FacetOffset<dim>    offset = offset_of(o, share);
        const unsigned int        first  = next;
        while (next < pairs.size() && pairs[next].first == f)
          ++next;
        if (is_released(o))
          continue;

        const std::size_t first_active = active.size();
        for (unsigned int k = first; k < next; ++k)
          active.push_back({f, pairs[k].second, {}});

        // each point belongs to the nearest facet that it hits
        for (const auto &[xi, w] :
             kernel.fixed_points(facet.current.n_vertices))
          {
            std::optional<typename PairKernel<dim>::Hit> best;
            unsigned int                                 best_pair = 0;
            for (unsigned int k = first; k < next; ++k)
              {
                const auto hit =
                  kernel.hit(frame, xi, primary.facets[pairs[k].second]);
                if (hit &&
                    (!best || std::abs(hit->depth) < std::abs(best->depth)))
                  {
                    best      = hit;
                    best_pair = k;
                  }
              }
            if (best)
              kernel.add_fixed_point(
                frame,
                facet,
                offset,
                primary.facets[pairs[best_pair].second],
                xi,
                best->eta,
                weight * w,
                with_tangent,
                active[first_active + best_pair - first].block);
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
  std::optional<typename ContactSweep<dim>::Depth>
  ContactSweep<dim>::depth_at(const SecondaryFrame<dim>       &frame,
                              const PlanePoint<dim>           &xi,
                              const unsigned int               f,
                              const std::vector<unsigned int> &among,
                              const double                     deepest) const
  {
    std::optional<Depth> nearest;
    // Back faces of the primary that the point has passed, see below.
    double nearest_back = std::numeric_limits<double>::max();
    for (const unsigned int p : among)
      {
        const auto hit = kernel.hit(frame, xi, primary.facets[p]);
        if (!hit)
          continue;
        const double d = hit->depth + secondary.facets[f].surface_offset +
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
                                           hit->eta)};
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
    // Small overlaps at a corner are looked for at this share of the way from
    // the corner to the centre.
    constexpr double inside_corner = 1e-3;

    const Facet<dim>         &facet = secondary.facets[f].current;
    const unsigned int        n     = facet.n_vertices;
    const SecondaryFrame<dim> frame(facet);
    FacetDepths               result;
    const auto                look = [&](const PlanePoint<dim> &xi) {
      const auto d = depth_at(frame, xi, f, among, deepest);
      if (d && (!result.deepest || d->depth > result.deepest->depth))
        {
          result.deepest = d;
          result.position = interpolate(facet, shape_values<dim>(n, xi));
        }
      return d;
    };
    for (const PlanePoint<dim> &xi : material_points<dim>(n))
      result.at_points.push_back(look(xi));
    if (!result.deepest)
      for (unsigned int a = 0; a < n; ++a)
        {
          const PlanePoint<dim> corner = reference_vertex<dim>(n, a);
          look(corner + inside_corner * (reference_centre<dim>(n) - corner));
        }
    return result;
  }


  template <int dim>
  InitialFindings<dim>
  ContactSweep<dim>::detect_initial(const InitialTreatment &treatment)
  {
    // Penetrations beyond what is treated must be found to be reported.
    constexpr double      look_deeper = 2.;
    std::vector<Box<dim>> boxes;
    for (const auto &p : primary.facets)
      boxes.push_back(box_around(p.current));
    const BroadPhase<dim> broad_phase(boxes);

    InitialFindings<dim> findings;
    history.level.clear();
    history.released.clear();
    for (unsigned int o = 0; o < owned.size(); ++o)
      {
        // Step 1: the primary facets around.
        const unsigned int       f     = owned[o];
        const ContactFacet<dim> &facet = secondary.facets[f];
        const unsigned int       n     = facet.current.n_vertices;
        const double             l     = longest(f);
        // at least as deep as contact will act
        const double range =
          std::max(kernel.options.ceiling * l,
                   look_deeper * ((treatment.deepest > 0.) ?
                                    treatment.deepest :
                                    treatment.largest_share * l));
        const SecondaryFrame<dim> frame(facet.current);
        Box<dim>                  box = box_around(facet.current);
        for (unsigned int a = 0; a < n; ++a)
          for (const double by : {-range, l})
            extend(box, Tensor<1, dim>(facet.current.x[a] + by * frame.normal));
        inflate(box, margin + surface_offset);
        std::vector<unsigned int> near = broad_phase.find(box);
        near.erase(std::remove_if(near.begin(),
                                  near.end(),
                                  [&](const unsigned int p) {
                                    return PairFilter<dim>::share_vertex(
                                      secondary, f, primary, p);
                                  }),
                   near.end());
        if (near.empty())
          continue;

        // Step 2: how deep?
        const FacetDepths           depths  = depths_of(f, near, range);
        const std::optional<Depth> &deepest = depths.deepest;
        if (!deepest || !(deepest->depth > 0.))
          continue;

        // Step 3: too deep to be treated?
        const double limit =
          (treatment.deepest > 0.) ?
            treatment.deepest :
            treatment.largest_share * deepest->stiffness.length;
        if (deepest->depth > limit)
          {
            ++findings.n_too_deep;
            if (deepest->depth > findings.too_deep)
              {
                findings.too_deep          = deepest->depth;
                findings.too_deep_facet    = f;
                findings.too_deep_position = depths.position;
              }
            if (history.released.empty())
              history.released.resize(owned.size(), false);
            history.released[o] = true;
            continue;
          }

        ++findings.n_facets;
        if (deepest->depth > findings.depth)
          {
            findings.depth    = deepest->depth;
            findings.facet    = f;
            findings.position = depths.position;
          }
        if (!treatment.store)
          continue;

        // Step 4: keep the levels.
        if (history.level.empty())
          history.level.resize(owned.size(), VertexValues<dim>{});
        for (unsigned int q = 0; q < depths.at_points.size(); ++q)
          {
            const Depth  at = *depths.of_point(q);
            const double remaining =
              at.stiffness.length *
              law.inverse(treatment.remaining_pressure / at.stiffness.modulus);
            history.level[o][q] =
              (at.depth > 0.) ? at.depth - remaining : at.depth;
          }
      }
    restore(history);
    return findings;
  }


  template <int dim>
  void
  ContactSweep<dim>::restore(const ContactHistory<dim> &saved)
  {
    AssertThrow((saved.level.empty() || saved.level.size() == owned.size()) &&
                  (saved.released.empty() ||
                   saved.released.size() == owned.size()),
                ExcMessage("The saved state belongs to another surface."));
    history       = saved;
    deepest_level = 0.;
    for (const VertexValues<dim> &levels : history.level)
      for (const double level : levels)
        deepest_level = std::max(deepest_level, level);
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
  ContactSweep<dim>::commit(const bool                       track,
                            const std::vector<unsigned int> &released)
  {
    if (history.level.empty() && history.released.empty() && released.empty())
      return;

    unsigned int next = 0;
    for (unsigned int o = 0; o < owned.size(); ++o)
      {
        const unsigned int        f = owned[o];
        std::vector<unsigned int> near;
        while (next < pairs.size() && pairs[next].first < f)
          ++next;
        for (; next < pairs.size() && pairs[next].first == f; ++next)
          near.push_back(pairs[next].second);

        const bool follows = track && !history.level.empty();
        if (!follows && !is_released(o))
          continue;

        // a released facet may have sunk out of reach: look at everything
        if (is_released(o))
          {
            near.resize(primary.facets.size());
            std::iota(near.begin(), near.end(), 0u);
          }
        const FacetDepths depths =
          depths_of(f,
                    near,
                    is_released(o) ? std::numeric_limits<double>::max() :
                                     reach(f));
        if (follows)
          for (unsigned int q = 0; q < depths.at_points.size(); ++q)
            {
              // out of sight is open
              const std::optional<Depth> &d = depths.of_point(q);
              history.level[o][q] =
                std::min(history.level[o][q], d ? d->depth : 0.);
            }
        const bool is_open = !depths.deepest || depths.deepest->depth <= 0.;
        if (is_released(o) && is_open)
          history.released[o] = false;
      }

    if (!released.empty())
      {
        if (history.released.empty())
          history.released.resize(owned.size(), false);
        for (const unsigned int f : released)
          history.released[std::lower_bound(owned.begin(), owned.end(), f) -
                           owned.begin()] = true;
      }
  }


  template <int dim>
  double
  ContactSweep<dim>::safe_step(const std::vector<Facet<dim>> &moved_s,
                               const std::vector<Facet<dim>> &moved_p) const
  {
    double step = 1.;
    if (owned.empty() || moved_p.empty())
      return step;

    std::vector<Box<dim>> boxes;
    for (unsigned int p = 0; p < moved_p.size(); ++p)
      {
        boxes.push_back(box_around(primary.facets[p].current));
        for (unsigned int a = 0; a < moved_p[p].n_vertices; ++a)
          extend(boxes.back(), moved_p[p].x[a]);
      }
    const BroadPhase<dim> broad_phase(boxes);
    const PairFilter<dim> filter(secondary,
                                 primary,
                                 kernel.options.zero_cosine);

    for (const unsigned int f : owned)
      {
        const ContactFacet<dim> &facet = secondary.facets[f];
        const Tensor<1, dim>     w     = centre_normal(facet.current);
        const Tensor<1, dim>     n     = w / w.norm();
        Box<dim>                 box   = box_around(facet.current);
        double advance                 = std::numeric_limits<double>::lowest();
        double front                   = advance;
        for (unsigned int a = 0; a < facet.current.n_vertices; ++a)
          {
            extend(box, moved_s[f].x[a]);
            front = std::max(front, n * facet.current.x[a]);
            advance =
              std::max(advance, n * (moved_s[f].x[a] - facet.current.x[a]));
          }
        inflate(box, surface_offset);
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
            const double allowed =
              std::max(gap, 0.) + safe_share * largest(facet);
            if (gap > -reach(f) - diameter(other) && closing > allowed)
              step = std::min(step, allowed / closing);
          }
      }
    return step;
  }


  template class ContactSweep<2>;
  template class ContactSweep<3>;
} // namespace MortarContact
