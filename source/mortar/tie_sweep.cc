// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/mortar/tie_sweep.h>
#include <mortar_contact/search/broad_phase.h>
#include <mortar_contact/search/material_locator.h>
#include <mortar_contact/search/pair_filter.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace MortarContact
{
  namespace
  {
    /// Tolerance of ties as a share of the facet's diameter.
    constexpr double default_tolerance = 0.05;

    /// How far the other side may be to be tied [m].
    template <int dim>
    double
    near_of(const Facet<dim> &facet, const double tolerance)
    {
      return (tolerance > 0.) ? tolerance : default_tolerance * diameter(facet);
    }

    /// Where facets lie that this one may be tied to.
    template <int dim>
    Box<dim>
    region_of(const Facet<dim> &facet, const double near, const double offsets)
    {
      Box<dim> box = box_around(facet);
      inflate(box, near + offsets);
      return box;
    }
  } // namespace


  template <int dim>
  std::vector<Box<dim>>
  tie_regions(const Skin<dim> &secondary,
              const Skin<dim> &primary,
              const double     tolerance)
  {
    std::vector<Box<dim>> result;
    for (unsigned int f = 0; f < secondary.n_own; ++f)
      {
        const Facet<dim> &facet = secondary.facets[f].current;
        result.push_back(region_of(facet,
                                   near_of(facet, tolerance),
                                   secondary.sizes.largest_offset +
                                     primary.sizes.largest_offset));
      }
    return result;
  }


  template <int dim>
  TieSweep<dim>::TieSweep(const Skin<dim>       &secondary,
                          const Skin<dim>       &primary,
                          const TieStrength     &strength,
                          const PairKernel<dim> &kernel,
                          const double           scale,
                          const double           tolerance)
    : secondary(secondary)
    , primary(primary)
    , law(strength)
    , symmetrise(kernel.options.symmetrise)
  {
    std::vector<Box<dim>> boxes;
    for (const auto &p : primary.facets)
      boxes.push_back(box_around(p.current));
    const BroadPhase<dim> broad_phase(boxes);
    const PairFilter<dim> filter(secondary,
                                 primary,
                                 kernel.options.zero_cosine,
                                 kernel.options.ceiling);

    for (unsigned int f = 0; f < secondary.n_own; ++f)
      {
        const ContactFacet<dim> &facet = secondary.facets[f];
        // now at time 0; undeformed, but rigid bodies in their place
        const SecondaryFrame<dim> frame(facet.current);
        const double              near = near_of(facet.current, tolerance);
        at_start.area += area(facet.reference);

        double tied = 0.;
        for (const unsigned int p :
             broad_phase.find(region_of(facet.current,
                                        near,
                                        secondary.sizes.largest_offset +
                                          primary.sizes.largest_offset)))
          {
            if (!filter.face_each_other(f, p))
              continue;
            std::vector<TiePoint<dim>> points;
            for (const auto &q :
                 kernel.segment_points(frame, facet, primary.facets[p]))
              {
                const PrimaryPoint<dim> at =
                  kernel.primary_point(primary.facets[p], nullptr, q.eta);
                TiePoint<dim> tie;
                tie.xi     = q.xi;
                tie.eta    = q.eta;
                tie.weight = q.weight;
                tie.apart =
                  apart(frame, primary.facets[p].current, q.xi, q.eta);
                const double gap = -tie.apart[dim - 1] - facet.surface_offset -
                                   at.surface_offset;
                if (std::abs(gap) > near)
                  continue;
                const ContactStiffness k =
                  kernel.stiffness(facet, q.xi, primary.facets[p], q.eta);
                tie.stiffness = scale * k.modulus / k.length;
                at_start.largest_gap =
                  std::max(at_start.largest_gap, std::abs(gap));
                at_start.tied_area += tie.weight;
                at_start.brittle =
                  std::max(at_start.brittle, law.brittleness(tie.stiffness));
                points.push_back(tie);
              }
            if (points.empty())
              continue;
            for (const TiePoint<dim> &tie : points)
              tied += tie.weight;
            pairs.emplace_back(f, p);
            ties.push_back(points);
          }
        if (tied == 0.)
          ++at_start.n_free_facets;
        else
          at_start.loose_area += std::max(0., area(facet.reference) - tied);
      }
    trial.resize(ties.size());
    for (std::size_t i = 0; i < ties.size(); ++i)
      trial[i].resize(ties[i].size());
  }


  template <int dim>
  void
  TieSweep<dim>::evaluate(const bool with_tangent)
  {
    active.clear();
    opening = 0.;
    for (std::size_t i = 0; i < ties.size(); ++i)
      {
        const auto               &facet = secondary.facets[pairs[i].first];
        const SecondaryFrame<dim> frame(facet.current);
        const Facet<dim> &other = primary.facets[pairs[i].second].current;
        active.push_back({pairs[i].first, pairs[i].second, {}});
        PairBlock<dim> &block = active.back().block;
        TiedPair<dim>   pair(frame, other, law, with_tangent, block);
        for (std::size_t q = 0; q < ties[i].size(); ++q)
          {
            const TiePoint<dim> &tie = ties[i][q];
            // an open tie that has failed does nothing
            trial[i][q] = pair.add(tie).history;
            if (tie.history.damage < 1.)
              opening = std::max(
                opening,
                (apart(frame, other, tie.xi, tie.eta) - tie.apart).norm());
          }
        pair.finish();
        if (symmetrise && with_tangent)
          PairAlgebra::symmetrise(block.tangent);
      }
    // facets that nothing holds any more are ordinary contact
    const std::vector<char> held = holds();
    active.erase(std::remove_if(active.begin(),
                                active.end(),
                                [&](const ActivePair &pair) {
                                  return !held[pair.secondary];
                                }),
                 active.end());
  }


  template <int dim>
  void
  TieSweep<dim>::commit()
  {
    for (std::size_t i = 0; i < ties.size(); ++i)
      for (std::size_t q = 0; q < ties[i].size(); ++q)
        {
          TieHistory       &old = ties[i][q].history;
          const TieHistory &now = trial[i][q];
          // trapezoidal rule over the damage of the step; OPTION 2 was whole
          const double release =
            (law.strength.law == TieStrength::Law::strength) ?
              now.release :
              0.5 * (old.release + now.release);
          dissipated += ties[i][q].weight * release * (now.damage - old.damage);
          old = now;
        }
  }


  template <int dim>
  std::vector<char>
  TieSweep<dim>::holds() const
  {
    std::vector<char> result(secondary.n_own, false);
    for (std::size_t i = 0; i < ties.size(); ++i)
      for (const TiePoint<dim> &tie : ties[i])
        if (tie.history.damage < 1.)
          result[pairs[i].first] = true;
    return result;
  }


  template <int dim>
  TieCounts
  TieSweep<dim>::counts() const
  {
    TieCounts result  = at_start;
    result.dissipated = dissipated;
    for (const auto &of_pair : ties)
      for (const TiePoint<dim> &tie : of_pair)
        {
          if (tie.history.damage == 0.)
            result.whole_area += tie.weight;
          if (tie.history.damage >= 1.)
            result.failed_area += tie.weight;
        }
    return result;
  }


  template <int dim>
  TiesHistory<dim>
  TieSweep<dim>::history() const
  {
    TiesHistory<dim> result;
    for (std::size_t i = 0; i < ties.size(); ++i)
      for (const TiePoint<dim> &tie : ties[i])
        result.ties.emplace_back(undeformed_place(pairs[i].first, tie),
                                 tie.history);
    result.dissipated = dissipated;
    return result;
  }


  template <int dim>
  void
  TieSweep<dim>::continue_from(const TiesHistory<dim> &saved,
                               const bool              keeps_sum)
  {
    std::vector<Tensor<1, dim>> places;
    for (const auto &tie : saved.ties)
      places.push_back(tie.first);
    const PointLocator<dim> locator(places);
    for (std::size_t i = 0; i < ties.size(); ++i)
      for (TiePoint<dim> &tie : ties[i])
        if (const auto nearest = locator.find(
              undeformed_place(pairs[i].first, tie),
              0.01 * diameter(secondary.facets[pairs[i].first].reference)))
          tie.history = saved.ties[*nearest].second;
    dissipated = keeps_sum ? saved.dissipated : 0.;
  }


  template <int dim>
  Tensor<1, dim>
  TieSweep<dim>::undeformed_place(const unsigned int   f,
                                  const TiePoint<dim> &tie) const
  {
    const Facet<dim> &facet = secondary.facets[f].reference;
    return interpolate(facet, shape_values<dim>(facet.n_vertices, tie.xi));
  }


  template std::vector<Box<2>>
  tie_regions(const Skin<2> &, const Skin<2> &, const double);
  template std::vector<Box<3>>
  tie_regions(const Skin<3> &, const Skin<3> &, const double);
  template class TieSweep<2>;
  template class TieSweep<3>;
} // namespace MortarContact
