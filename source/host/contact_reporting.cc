// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pair_forces.h"

#include <mortar_contact/host/contact_interface.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace MortarContact
{
  template <int dim>
  void
  ContactInterface<dim>::detect_initial_penetrations()
  {
    InitialTreatment treatment;
    treatment.largest_share      = parameters.largest_share();
    treatment.deepest            = parameters.deepest_penetration;
    treatment.remaining_pressure = parameters.initial_pressure;
    treatment.store =
      parameters.initial_penetration != InitialPenetration::stress;

    InitialReport &initial = last_report.initial;
    initial.treatment      = parameters.initial_penetration;
    initial.asked_pressure = parameters.initial_pressure;

    (void)bring_near([&]() {
      std::vector<std::vector<Box<dim>>> regions;
      for (const auto &sweep : sweeps)
        regions.push_back(sweep->initial_regions(treatment));
      return regions;
    });
    std::vector<DeepPenetration> deepest, undetected;
    for (unsigned int i = 0; i < sweeps.size(); ++i)
      {
        const InitialFindings<dim> found = sweeps[i]->detect_initial(treatment);
        const auto                &labels = surfaces[side_of(i, 0)].labels;
        initial.n_facets += Utilities::MPI::sum(found.n_facets, communicator);
        initial.n_undetected +=
          Utilities::MPI::sum(found.n_too_deep, communicator);
        if (found.n_facets > 0)
          deepest.push_back(
            {found.depth,
             found.depth / (treatment.largest_share * found.length),
             labels[found.facet],
             {},
             in_space(found.position)});
        if (found.n_too_deep > 0)
          undetected.push_back(
            {found.too_deep,
             found.too_deep / (treatment.largest_share * found.too_deep_length),
             labels[found.too_deep_facet],
             {},
             in_space(found.too_deep_position)});
      }
    const auto deepest_of_all = [&](const std::vector<DeepPenetration> &local) {
      DeepPenetration result;
      for (const auto &of_rank :
           Utilities::MPI::all_gather(communicator, local))
        for (const auto &p : of_rank)
          if (p.penetration > result.penetration)
            result = p;
      return result;
    };
    initial.deepest    = deepest_of_all(deepest);
    initial.undetected = deepest_of_all(undetected);

    if (parameters.initial_penetration == InitialPenetration::remove_deep &&
        initial.n_undetected > 0)
      {
        std::ostringstream message;
        message << "Interface '" << name
                << "': 'Deepest initial penetration' (MPAR2) is "
                << parameters.deepest_penetration << ", but cell "
                << initial.undetected.secondary.cell << " of '"
                << initial.undetected.secondary.part << "' penetrates by "
                << initial.undetected.penetration << " at ("
                << initial.undetected.position
                << "). Expected a value above the deepest initial penetration.";
        AssertThrow(false, ExcMessage(message.str()));
      }
  }


  template <int dim>
  std::vector<char>
  ContactInterface<dim>::pairs_behind(const ContactSweep<dim> &sweep,
                                      const unsigned int       i) const
  {
    // where rigid bodies were is not known
    if (!rigid_bodies.empty() || !has_accepted_values ||
        sweep.too_deep(deepest_share()).empty())
      return {};
    std::array<std::vector<double>, 2> motion; ///< Largest of each facet.
    for (unsigned int role = 0; role < 2; ++role)
      {
        const ContactSurface<dim> &surface = surfaces[side_of(i, role)];
        const auto                 before  = surface.moved(
          [&](const auto dof) { return accepted_values[place_of(dof)]; });
        for (unsigned int f = 0; f < before.size(); ++f)
          {
            const Facet<dim> &now  = surface.skin.facets[f].current;
            double            most = 0.;
            for (unsigned int a = 0; a < now.n_vertices; ++a)
              most = std::max(most, (now.x[a] - before[f].x[a]).norm());
            motion[role].push_back(most);
          }
      }
    std::vector<char> behind;
    for (const auto &pair : sweep.active_pairs())
      {
        const PairBlock<dim> &block = pair.block;
        const double          share = deepest_share();
        const double          lost =
          block.penetration * (1. - share / block.relative_penetration);
        behind.push_back(block.relative_penetration > share &&
                         motion[0][pair.secondary] + motion[1][pair.primary] <
                           lost);
      }
    return behind;
  }


  template <int dim>
  void
  ContactInterface<dim>::make_report()
  {
    ContactReport &r = last_report;
    // Step 1: sums and maxima of this rank.
    std::vector<double> sums(18, 0.), maxima(9, 0.);
    maxima[2] = maxima[7] = std::numeric_limits<double>::lowest();
    std::vector<DeepPenetration> worst;
    for (unsigned int i = 0; i < sweeps.size(); ++i)
      {
        const ContactSweep<dim> &sweep   = *sweeps[i];
        const auto              &counts  = sweep.counts();
        const double             added[] = {double(sweep.candidates().size()),
                                            double(counts.active),
                                            double(counts.open),
                                            double(counts.apart),
                                            double(counts.beyond),
                                            double(counts.degenerate),
                                            double(sweep.too_deep(deepest_share()).size())};
        for (unsigned int k = 0; k < 7; ++k)
          sums[k] += added[k];
        maxima[2] = std::max(maxima[2], -counts.smallest_gap);
        maxima[7] = std::max(maxima[7], counts.largest_gap);
        maxima[3] = std::max(maxima[3], counts.overlap);
        maxima[8] += counts.active + counts.open;
        for (const auto &pair : sweep.active_pairs())
          {
            const PairBlock<dim> &block = pair.block;
            sums[7] += block.active_area;
            sums[8] += block.energy;
            sums[9] += block.penetration_volume;
            sums[16] += block.slip_area;
            sums[17] += block.dissipation;
            maxima[4] = std::max(maxima[4], block.elastic_slip);
            maxima[6] = std::max(maxima[6], block.pressure);
            const double relative =
              block.relative_penetration / parameters.largest_share();
            maxima[0] = std::max(maxima[0], block.penetration);
            maxima[1] = std::max(maxima[1], relative);
            worst.push_back({block.penetration,
                             relative,
                             surfaces[side_of(i, 0)].labels[pair.secondary],
                             obstacle ?
                               FacetLabel{obstacle->name, 0} :
                               surfaces[side_of(i, 1)].labels[pair.primary],
                             in_space(block.deepest_position)});
          }
      }

    // Forces by part; the secondary is side 0.
    std::vector<double> of_parts(6 * part_names.size(), 0.);
    for_each_pair([&](const unsigned int i, const auto &pair) {
      for_each_force<dim>(
        surfaces[side_of(i, 0)].skin,
        obstacle ? nullptr : &surfaces[side_of(i, 1)].skin,
        pair,
        [&](const unsigned int  role,
            const Tensor<1, 3> &x,
            const Tensor<1, 3> &force) {
          const Tensor<1, 3> moment = cross_product_3d(x, force);
          const unsigned int facet =
            (role == 0) ? pair.secondary : pair.primary;
          double *of_part =
            &of_parts[6 * part_of_facet(side_of(i, role), facet)];
          for (unsigned int c = 0; c < 3; ++c)
            {
              of_part[c] += force[c];
              of_part[3 + c] += moment[c];
              if (role == i)
                {
                  sums[10 + c] += force[c];
                  sums[13 + c] += moment[c];
                }
            }
          if (obstacle)
            for (unsigned int c = 0; c < 3; ++c)
              {
                of_parts[6 * part_of_obstacle + c] -= force[c];
                of_parts[6 * part_of_obstacle + 3 + c] -= moment[c];
              }
        });
    });
    Utilities::MPI::sum(of_parts, communicator, of_parts);
    r.parts.clear();
    for (unsigned int k = 0; k < part_names.size(); ++k)
      {
        const double *of_part = &of_parts[6 * k];
        r.parts.push_back({part_names[k],
                           Tensor<1, 3>({of_part[0], of_part[1], of_part[2]}),
                           Tensor<1, 3>({of_part[3], of_part[4], of_part[5]})});
      }
    if (tie_sweep)
      {
        maxima[5] = tie_sweep->largest_opening();
        for (const auto &pair : tie_sweep->active_pairs())
          sums[8] += pair.block.energy;
      }

    // Step 2: over the ranks.
    Utilities::MPI::sum(sums, communicator, sums);
    Utilities::MPI::max(maxima, communicator, maxima);
    r.candidate_pairs    = std::lround(sums[0]);
    r.active_pairs       = std::lround(sums[1]);
    r.open_pairs         = std::lround(sums[2]);
    r.apart_pairs        = std::lround(sums[3]);
    r.beyond_pairs       = std::lround(sums[4]);
    r.degenerate_pairs   = std::lround(sums[5]);
    r.n_too_deep         = std::lround(sums[6]);
    r.busiest_rank_pairs = std::lround(maxima[8]);
    r.active_area        = sums[7];
    r.energy             = sums[8];
    r.mean_penetration   = sums[7] > 0. ? sums[9] / sums[7] : 0.;
    for (unsigned int c = 0; c < 3; ++c)
      {
        r.force[c]  = sums[10 + c];
        r.moment[c] = sums[13 + c];
      }
    // the pairs of a single surface have no common side
    if (parameters.kind == ContactParameters::Kind::automatic_single_surface)
      {
        r.force_on = r.parts[0].name;
        r.force    = r.parts[0].force;
        r.moment   = r.parts[0].moment;
      }
    r.largest_penetration  = maxima[0];
    r.relative_penetration = maxima[1];
    r.smallest_gap         = -maxima[2];
    r.largest_gap          = maxima[7];
    r.largest_overlap      = maxima[3];
    r.slip_area            = sums[16];
    r.dissipation          = dissipation + sums[17];
    r.elastic_slip         = maxima[4];
    r.largest_pressure     = maxima[6];
    r.largest_tie_jump     = maxima[5];
    if (tie_sweep)
      {
        const TieCounts     ties  = tie_sweep->counts();
        std::vector<double> areas = {ties.whole_area,
                                     ties.failed_area,
                                     ties.dissipated};
        Utilities::MPI::sum(areas, communicator, areas);
        r.whole_tied_area    = areas[0];
        r.failed_tied_area   = areas[1];
        r.damage_dissipation = areas[2];
      }

    // Step 3: the worst facets, deepest first, one line per facet.
    const auto deeper = [](const DeepPenetration &a, const DeepPenetration &b) {
      return std::tie(b.penetration, a.secondary.part, a.secondary.cell) <
             std::tie(a.penetration, b.secondary.part, b.secondary.cell);
    };
    const auto keep_worst = [&](std::vector<DeepPenetration> &list) {
      std::sort(list.begin(), list.end(), deeper);
      std::vector<DeepPenetration> kept;
      for (const auto &p : list)
        {
          if (kept.size() >= parameters.n_worst_facets)
            break;
          const bool known =
            std::any_of(kept.begin(), kept.end(), [&](const auto &k) {
              return k.secondary.cell == p.secondary.cell &&
                     k.secondary.part == p.secondary.part;
            });
          if (!known)
            kept.push_back(p);
        }
      list = kept;
    };
    keep_worst(worst);
    r.worst.clear();
    if (r.active_pairs == 0)
      return;
    for (const auto &of_rank : Utilities::MPI::all_gather(communicator, worst))
      r.worst.insert(r.worst.end(), of_rank.begin(), of_rank.end());
    keep_worst(r.worst);
  }


  template <int dim>
  StepAdvice
  ContactInterface<dim>::advice() const
  {
    StepAdvice advice;
    if (!is_finite)
      {
        advice.accept = false;
        advice.reason = "interface '" + name +
                        "': displacements are not numbers, or infinite";
      }
    else if (largest_tool_step < 1.)
      {
        std::ostringstream reason;
        reason << "interface '" << name
               << "': a rigid body moves past what is in its way in one step; "
                  "at most "
               << largest_tool_step << " of the step is safe";
        advice.accept = false;
        advice.reason = reason.str();
      }
    else if (!is_augmented)
      {
        std::ostringstream reason;
        reason << "interface '" << name << "': penetrations are above "
               << parameters.augmentation.tolerance << " after "
               << parameters.augmentation.most << " augmentations";
        advice.accept = false;
        advice.reason = reason.str();
      }
    else if (last_report.n_too_deep > 0 &&
             parameters.release != ContactParameters::Release::report)
      {
        std::ostringstream reason;
        reason.precision(4);
        reason << "interface '" << name << "': " << last_report.n_too_deep
               << " facets penetrate beyond the release depth, the deepest by "
               << last_report.largest_penetration << " ("
               << 100. * last_report.relative_penetration << " %)";
        if (!last_report.worst.empty())
          reason << ", cell " << last_report.worst[0].secondary.cell << " of '"
                 << last_report.worst[0].secondary.part << "'";
        advice.accept = false;
        advice.reason = reason.str();
      }
    return advice;
  }


  template <int dim>
  double
  ContactInterface<dim>::integration_error(const unsigned int most_facets) const
  {
    using Rule               = Integration::Rule;
    const Integration &used  = parameters.integration;
    Integration        other = used;
    if (obstacle)
      {
        // no segments: twice as many points
        other.rule = Rule::points;
        other.points_per_direction =
          (used.rule == Rule::nodes) ? 10 : 2 * used.points_per_direction;
      }
    else
      {
        constexpr unsigned int highest = 6;
        other.degree = (used.rule == Rule::segments && used.degree == highest) ?
                         highest - 1 :
                         highest;
        other.rule   = Rule::segments;
      }
    std::vector<double> sums(2, 0.);
    for (const auto &sweep : sweeps)
      {
        const std::array<double, 2> of_sweep =
          sweep->compare(other, most_facets);
        sums[0] += of_sweep[0];
        sums[1] += of_sweep[1];
      }
    Utilities::MPI::sum(sums, communicator, sums);
    return (sums[1] > 0.) ? sums[0] / sums[1] : 0.;
  }


  template void
  ContactInterface<2>::detect_initial_penetrations();
  template std::vector<char>
  ContactInterface<2>::pairs_behind(const ContactSweep<2> &,
                                    const unsigned int) const;
  template void
  ContactInterface<2>::make_report();
  template StepAdvice
  ContactInterface<2>::advice() const;
  template double
  ContactInterface<2>::integration_error(const unsigned int) const;
  template void
  ContactInterface<3>::detect_initial_penetrations();
  template std::vector<char>
  ContactInterface<3>::pairs_behind(const ContactSweep<3> &,
                                    const unsigned int) const;
  template void
  ContactInterface<3>::make_report();
  template StepAdvice
  ContactInterface<3>::advice() const;
  template double
  ContactInterface<3>::integration_error(const unsigned int) const;
} // namespace MortarContact
