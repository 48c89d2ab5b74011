// SPDX-License-Identifier: LGPL-2.1-or-later

// How ContactSweep finds penetrations at the start, and the levels that take
// them off.

#include <mortar_contact/laws/initial_penetration.h>
#include <mortar_contact/mortar/contact_sweep.h>
#include <mortar_contact/search/broad_phase.h>
#include <mortar_contact/search/pair_filter.h>

#include <algorithm>
#include <cmath>

namespace MortarContact
{
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


  template ContactSweep<2>::FacetDepths
  ContactSweep<2>::depths_of(const unsigned int,
                             const std::vector<unsigned int> &,
                             const double) const;
  template std::array<double, 2>
  ContactSweep<2>::initial_ranges(const unsigned int,
                                  const SecondaryFrame<2> &,
                                  const InitialTreatment &) const;
  template Box<2>
  ContactSweep<2>::initial_region(const unsigned int,
                                  const InitialTreatment &) const;
  template std::vector<Box<2>>
  ContactSweep<2>::initial_regions(const InitialTreatment &) const;
  template InitialFindings<2>
  ContactSweep<2>::detect_initial(const InitialTreatment &);
  template ContactSweep<3>::FacetDepths
  ContactSweep<3>::depths_of(const unsigned int,
                             const std::vector<unsigned int> &,
                             const double) const;
  template std::array<double, 2>
  ContactSweep<3>::initial_ranges(const unsigned int,
                                  const SecondaryFrame<3> &,
                                  const InitialTreatment &) const;
  template Box<3>
  ContactSweep<3>::initial_region(const unsigned int,
                                  const InitialTreatment &) const;
  template std::vector<Box<3>>
  ContactSweep<3>::initial_regions(const InitialTreatment &) const;
  template InitialFindings<3>
  ContactSweep<3>::detect_initial(const InitialTreatment &);
} // namespace MortarContact
