// SPDX-License-Identifier: LGPL-2.1-or-later

// What ContactSweep remembers, and how it goes on elsewhere.

#include <mortar_contact/mortar/contact_sweep.h>
#include <mortar_contact/search/material_locator.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <string>

namespace MortarContact
{
  namespace
  {
    /// A facet's centre is this near, in its diameters, to the facet of another
    /// mesh that it is part of.
    constexpr double same_facet = 0.25;

    /// And lies within it by this much of its reference coordinates: centres of
    /// its neighbours are moved to its edges by the search.
    constexpr double inside = 1e-3;
  } // namespace

  template <int dim>
  void
  ContactSweep<dim>::drop_pairs_aside()
  {
    if (history.aside.empty())
      return;
    pairs.erase(std::remove_if(pairs.begin(),
                               pairs.end(),
                               [&](const auto &pair) {
                                 return std::binary_search(
                                   history.aside.begin(),
                                   history.aside.end(),
                                   pair);
                               }),
                pairs.end());
  }


  template <int dim>
  void
  ContactSweep<dim>::set_aside(const std::vector<char> &active_pairs)
  {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < active_pairs.size(); ++k)
      if (active_pairs[k])
        new_aside.emplace_back(active[k].secondary, active[k].primary);
      else
        {
          if (kept < k)
            active[kept] = active[k];
          ++kept;
        }
    if (!active_pairs.empty())
      active.erase(active.begin() + kept, active.end());
  }


  template <int dim>
  void
  ContactSweep<dim>::commit_pairs_aside()
  {
    if (history.aside.empty() && new_aside.empty())
      return;
    for (const auto &[s, p] : history.aside)
      {
        const SecondaryFrame<dim> frame(secondary.facets[s].current);
        PairBlock<dim>            block;
        kernel.evaluate_segments(frame,
                                 secondary.facets[s],
                                 {},
                                 primary.facets[p],
                                 nullptr,
                                 weight,
                                 false,
                                 block);
        if (block.is_active() || block.n_beyond > 0)
          new_aside.emplace_back(s, p);
        else
          searched_s.clear(); // it may be a candidate again: search
      }
    std::sort(new_aside.begin(), new_aside.end());
    history.aside = new_aside;
    new_aside.clear();
    drop_pairs_aside();
  }


  template <int dim>
  void
  ContactSweep<dim>::restore(const ContactHistory<dim> &saved)
  {
    const auto fits = [&](const auto &entries) {
      return entries.empty() || entries.size() == secondary.n_own;
    };
    AssertThrow(fits(saved.level) && fits(saved.released) &&
                  fits(saved.elastic_slip) && fits(saved.augmentation) &&
                  fits(saved.tied) &&
                  saved.elastic_slip.size() == history.elastic_slip.size(),
                ExcMessage("The saved state belongs to another surface."));
    history      = saved;
    augmentation = saved.augmentation;
    prepare_slips();
    deepest_level = 0.;
    for (const VertexValues<dim> &levels : history.level)
      for (const double level : levels)
        deepest_level = std::max(deepest_level, level);
  }


  template <int dim>
  void
  ContactSweep<dim>::store_before()
  {
    history.before = {{current_facets(secondary), current_facets(primary)}};
    prepare_slips();
  }


  template <int dim>
  void
  ContactSweep<dim>::prepare_slips()
  {
    slips.resize(history.elastic_slip.size());
    for (unsigned int f = 0; f < slips.size(); ++f)
      {
        const SecondaryFrame<dim> frame(history.before[0][f]);
        slips[f].before = frame.facet;
        slips[f].normal = frame.normal;
        slips[f].basis  = frame.basis;
        slips[f].elastic =
          extrapolate_to_vertices<dim>(frame.facet.n_vertices,
                                       history.elastic_slip[f]);
      }
  }


  template <int dim>
  void
  ContactSweep<dim>::start(const double share)
  {
    history.share = share;
  }


  template <int dim>
  void
  ContactSweep<dim>::rollback()
  {
    augmentation = history.augmentation;
  }


  template <int dim>
  void
  ContactSweep<dim>::set_tied(const std::vector<char> &is_held)
  {
    history.tied = is_held;
  }


  template <int dim>
  void
  ContactSweep<dim>::remember_primary(const std::vector<Facet<dim>> &before)
  {
    history.before[1].insert(history.before[1].end(),
                             before.begin(),
                             before.end());
  }


  template <int dim>
  std::vector<FacetHistory<dim>>
  ContactSweep<dim>::facet_histories() const
  {
    std::vector<FacetHistory<dim>> result(secondary.n_own);
    for (unsigned int f = 0; f < secondary.n_own; ++f)
      {
        FacetHistory<dim> &h = result[f];
        h.undeformed         = secondary.facets[f].reference;
        h.part               = secondary.parts[f];
        h.is_released        = is_released(f);
        if (!history.level.empty())
          h.level = history.level[f];
        if (!history.augmentation.empty())
          h.augmentation = history.augmentation[f];
        if (!history.elastic_slip.empty())
          {
            h.elastic_slip = history.elastic_slip[f];
            h.sliding      = history.sliding[f];
            h.accepted     = history.before[0][f];
          }
      }
    return result;
  }


  template <int dim>
  bool
  ContactSweep<dim>::remembers() const
  {
    return !history.level.empty() || !history.released.empty() ||
           !history.elastic_slip.empty() || !history.augmentation.empty();
  }


  template <int dim>
  SurfaceHistory<dim>
  ContactSweep<dim>::surface_history(const bool with_facets) const
  {
    SurfaceHistory<dim> result;
    if (with_facets)
      result.facets = facet_histories();
    result.has_levels       = !history.level.empty();
    result.has_releases     = !history.released.empty();
    result.has_slip         = !history.elastic_slip.empty();
    result.has_augmentation = !history.augmentation.empty();
    result.share            = history.share;
    for (const auto &[s, p] : history.aside)
      result.aside.push_back(
        {{{secondary.facets[s].reference, primary.facets[p].reference}},
         {{secondary.parts[s], primary.parts[p]}}});
    return result;
  }


  template <int dim>
  void
  ContactSweep<dim>::continue_from(const SurfaceHistory<dim> &saved,
                                   const bool                 follows_openings)
  {
    AssertThrow(saved.facets.empty() ||
                  saved.has_slip == kernel.point.has_friction(),
                ExcMessage("The saved state has " +
                           std::string(saved.has_slip ? "" : "no ") +
                           "friction, the interface has " +
                           std::string(saved.has_slip ? "none." : "some.")));
    std::vector<Facet<dim>>   facets;
    std::vector<unsigned int> parts;
    for (const FacetHistory<dim> &h : saved.facets)
      {
        facets.push_back(h.undeformed);
        parts.push_back(h.part);
      }
    const MaterialLocator<dim> locator(facets, parts);

    ContactHistory<dim> next = history;
    next.share               = saved.share;
    // levels that do not follow openings are those that were found on this
    // mesh: the other surface may be another, too
    if (saved.has_levels && follows_openings && next.level.empty())
      next.level.resize(secondary.n_own, VertexValues<dim>{});
    // so are facets that are too deep on it
    if (saved.has_releases && next.released.empty())
      next.released.resize(secondary.n_own, false);
    next.augmentation.assign(saved.has_augmentation ? secondary.n_own : 0,
                             VertexValues<dim>{});
    if (kernel.point.has_friction())
      {
        next.before = {{current_facets(secondary), current_facets(primary)}};
        next.elastic_slip.assign(
          secondary.n_own, std::array<PlanePoint<dim>, max_vertices<dim>>{});
        next.sliding.assign(secondary.n_own, VertexValues<dim>{});
      }
    for (unsigned int f = 0; f < secondary.n_own && !saved.facets.empty(); ++f)
      {
        const Facet<dim> &here = secondary.facets[f].reference;
        if (const auto twin = locator.same(here, secondary.parts[f]))
          {
            const FacetHistory<dim> &h = saved.facets[*twin];
            if (saved.has_levels && follows_openings)
              next.level[f] = h.level;
            if (saved.has_releases)
              next.released[f] = h.is_released;
            if (saved.has_augmentation)
              next.augmentation[f] = h.augmentation;
            if (saved.has_slip)
              {
                next.elastic_slip[f] = h.elastic_slip;
                next.sliding[f]      = h.sliding;
              }
            continue;
          }
        const Tensor<1, dim> normal = centre_normal(here);
        const auto           at     = [&](const PlanePoint<dim> &xi) {
          return locator.find(
            interpolate(here, shape_values<dim>(here.n_vertices, xi)),
            normal,
            secondary.parts[f]);
        };
        if (saved.has_releases)
          if (const auto place = at(reference_centre<dim>(here.n_vertices)))
            next.released[f] =
              next.released[f] || saved.facets[place->facet].is_released;
        const auto points = material_points<dim>(here.n_vertices);
        for (unsigned int q = 0; q < points.size(); ++q)
          {
            const auto place = at(points[q]);
            if (!place)
              continue;
            const FacetHistory<dim> &h = saved.facets[place->facet];
            const unsigned int       n = h.undeformed.n_vertices;
            const auto               N = shape_values<dim>(n, place->xi);
            const auto there = [&](const VertexValues<dim> &at_points) {
              const auto values = extrapolate_to_vertices<dim>(n, at_points);
              double     value  = 0.;
              for (unsigned int a = 0; a < n; ++a)
                value += N[a] * values[a];
              return value;
            };
            if (saved.has_levels && follows_openings)
              next.level[f][q] = there(h.level);
            if (saved.has_augmentation)
              next.augmentation[f][q] = std::max(0., there(h.augmentation));
            if (saved.has_slip)
              {
                next.sliding[f][q] = there(h.sliding);
                const auto slip =
                  extrapolate_to_vertices<dim>(n, h.elastic_slip);
                Tensor<1, dim>            vector;
                const SecondaryFrame<dim> frame(h.accepted);
                for (unsigned int a = 0; a < n; ++a)
                  for (unsigned int c = 0; c < dim - 1; ++c)
                    vector += N[a] * slip[a][c] * frame.basis[c];
                const SecondaryFrame<dim> now(next.before[0][f]);
                for (unsigned int c = 0; c < dim - 1; ++c)
                  next.elastic_slip[f][q][c] = now.basis[c] * vector;
              }
          }
      }
    next.aside                = pairs_like(saved.aside);
    const double reach_so_far = deepest_level;
    restore(next);
    if (!history.aside.empty() || !history.released.empty() ||
        deepest_level > reach_so_far)
      searched_s.clear(); // other candidates: search
  }


  template <int dim>
  std::vector<std::pair<unsigned int, unsigned int>>
  ContactSweep<dim>::pairs_like(
    const std::vector<typename SurfaceHistory<dim>::PairAside> &saved) const
  {
    std::vector<std::pair<unsigned int, unsigned int>> result;
    if (saved.empty())
      return result;
    // facets of this mesh by the saved pairs that they are part of
    std::array<std::vector<std::vector<unsigned int>>, 2> facets;
    for (unsigned int role = 0; role < 2; ++role)
      {
        const Skin<dim> &skin = (role == 0) ? secondary : primary;
        facets[role].resize(saved.size());
        std::vector<Facet<dim>>   old;
        std::vector<unsigned int> parts;
        for (const auto &pair : saved)
          {
            old.push_back(pair.undeformed[role]);
            parts.push_back(pair.parts[role]);
          }
        const MaterialLocator<dim> locator(old, parts);
        const unsigned int         n_facets =
          (role == 0) ? skin.n_own : skin.facets.size();
        for (unsigned int f = 0; f < n_facets; ++f)
          {
            const Facet<dim> &here = skin.facets[f].reference;
            const auto        place =
              locator.find(centre(here), centre_normal(here), skin.parts[f]);
            if (!place || place->distance > same_facet * diameter(here) ||
                !is_inside<dim>(old[place->facet].n_vertices,
                                place->xi,
                                -inside))
              continue;
            // one facet may be in several pairs
            const Facet<dim> &there = old[place->facet];
            for (unsigned int i = 0; i < saved.size(); ++i)
              if (parts[i] == skin.parts[f] && old[i].x == there.x)
                facets[role][i].push_back(f);
          }
      }
    for (unsigned int i = 0; i < saved.size(); ++i)
      for (const unsigned int s : facets[0][i])
        for (const unsigned int p : facets[1][i])
          result.emplace_back(s, p);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }


  template std::vector<FacetHistory<2>>
  ContactSweep<2>::facet_histories() const;
  template bool
  ContactSweep<2>::remembers() const;
  template SurfaceHistory<2>
  ContactSweep<2>::surface_history(const bool) const;
  template void
  ContactSweep<2>::continue_from(const SurfaceHistory<2> &, const bool);
  template void
  ContactSweep<2>::drop_pairs_aside();
  template void
  ContactSweep<2>::set_aside(const std::vector<char> &);
  template void
  ContactSweep<2>::commit_pairs_aside();
  template void
  ContactSweep<2>::restore(const ContactHistory<2> &);
  template void
  ContactSweep<2>::store_before();
  template void
  ContactSweep<2>::prepare_slips();
  template void
  ContactSweep<2>::start(const double);
  template void
  ContactSweep<2>::rollback();
  template void
  ContactSweep<2>::set_tied(const std::vector<char> &);
  template void
  ContactSweep<2>::remember_primary(const std::vector<Facet<2>> &);
  template std::vector<std::pair<unsigned int, unsigned int>>
  ContactSweep<2>::pairs_like(
    const std::vector<typename SurfaceHistory<2>::PairAside> &) const;
  template std::vector<FacetHistory<3>>
  ContactSweep<3>::facet_histories() const;
  template bool
  ContactSweep<3>::remembers() const;
  template SurfaceHistory<3>
  ContactSweep<3>::surface_history(const bool) const;
  template void
  ContactSweep<3>::continue_from(const SurfaceHistory<3> &, const bool);
  template void
  ContactSweep<3>::drop_pairs_aside();
  template void
  ContactSweep<3>::set_aside(const std::vector<char> &);
  template void
  ContactSweep<3>::commit_pairs_aside();
  template void
  ContactSweep<3>::restore(const ContactHistory<3> &);
  template void
  ContactSweep<3>::store_before();
  template void
  ContactSweep<3>::prepare_slips();
  template void
  ContactSweep<3>::start(const double);
  template void
  ContactSweep<3>::rollback();
  template void
  ContactSweep<3>::set_tied(const std::vector<char> &);
  template void
  ContactSweep<3>::remember_primary(const std::vector<Facet<3>> &);
  template std::vector<std::pair<unsigned int, unsigned int>>
  ContactSweep<3>::pairs_like(
    const std::vector<typename SurfaceHistory<3>::PairAside> &) const;
} // namespace MortarContact
