// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/host/contact_interface.h>
#include <mortar_contact/laws/law_library.h>
#include <mortar_contact/laws/paper_law.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

namespace MortarContact
{
  namespace
  {
    const char *const side_names[2] = {"secondary", "primary"};

  } // namespace


  template <int dim>
  ContactInterface<dim>::ContactInterface(const std::string       &name,
                                          const ContactParameters &parameters,
                                          const MPI_Comm           communicator)
    : name(name)
    , parameters(parameters)
    , communicator(communicator)
  {
    parameters.check();
    last_report.name = name;
    law =
      make_pressure_law(parameters.law,
                        parameters.stiffness_scale * parameters.penalty_factor,
                        parameters.progressive_stiffening,
                        parameters.largest_share(),
                        parameters.release ==
                          ContactParameters::Release::never);
    friction = parameters.friction.make();
  }


  template <int dim>
  void
  ContactInterface<dim>::add(const unsigned int        side,
                             const DoFHandler<dim>    &dof_handler,
                             const Mapping<dim>       &mapping,
                             const FaceSelection      &selection,
                             const ModulusOfCell<dim> &modulus_of_cell,
                             const std::string        &part,
                             const DoFNumbering       &numbering,
                             const unsigned int        first_component)
  {
    add_facets(side,
               extract_surface<dim>(dof_handler,
                                    mapping,
                                    selection,
                                    modulus_of_cell,
                                    part,
                                    numbering,
                                    first_component,
                                    communicator),
               part);
  }


  template <int dim>
  void
  ContactInterface<dim>::add_facets(
    const unsigned int                    side,
    const std::vector<SurfaceFacet<dim>> &facets,
    const std::string                    &part)
  {
    begin_adding();
    AssertThrow(Utilities::MPI::sum(facets.size(), communicator) > 0,
                ExcMessage("Interface '" + name + "': the " + side_names[side] +
                           " surface of '" + part +
                           "' is empty; no boundary face has one of the chosen "
                           "boundary or material ids."));
    extracted[side].insert(extracted[side].end(), facets.begin(), facets.end());
  }


  template <int dim>
  void
  ContactInterface<dim>::add_secondary(
    const DoFHandler<dim>    &dof_handler,
    const Mapping<dim>       &mapping,
    const FaceSelection      &selection,
    const ModulusOfCell<dim> &modulus_of_cell,
    const std::string        &part,
    const DoFNumbering       &numbering,
    const unsigned int        first_component)
  {
    add(0,
        dof_handler,
        mapping,
        selection,
        modulus_of_cell,
        part,
        numbering,
        first_component);
  }


  template <int dim>
  void
  ContactInterface<dim>::add_primary(const DoFHandler<dim>    &dof_handler,
                                     const Mapping<dim>       &mapping,
                                     const FaceSelection      &selection,
                                     const ModulusOfCell<dim> &modulus_of_cell,
                                     const std::string        &part,
                                     const DoFNumbering       &numbering,
                                     const unsigned int        first_component)
  {
    add(1,
        dof_handler,
        mapping,
        selection,
        modulus_of_cell,
        part,
        numbering,
        first_component);
  }


  template <int dim>
  void
  ContactInterface<dim>::add_secondary(
    const DoFHandler<dim - 1, dim> &dof_handler,
    const FaceSelection            &selection,
    const ShellSkin<dim>           &skin,
    const std::string              &part,
    const DoFNumbering             &numbering)
  {
    add_shell(0, dof_handler, selection, skin, part, numbering);
  }


  template <int dim>
  void
  ContactInterface<dim>::add_primary(
    const DoFHandler<dim - 1, dim> &dof_handler,
    const FaceSelection            &selection,
    const ShellSkin<dim>           &skin,
    const std::string              &part,
    const DoFNumbering             &numbering)
  {
    add_shell(1, dof_handler, selection, skin, part, numbering);
  }


  template <int dim>
  void
  ContactInterface<dim>::add_shell(const unsigned int              side,
                                   const DoFHandler<dim - 1, dim> &dof_handler,
                                   const FaceSelection            &selection,
                                   ShellSkin<dim>                  skin,
                                   const std::string              &part,
                                   const DoFNumbering             &numbering)
  {
    const double scale = parameters.thickness_scale;
    if (parameters.thickness > 0.)
      {
        skin.thickness    = parameters.thickness;
        skin.thickness_at = nullptr;
      }
    skin.thickness *= scale;
    if (skin.thickness_at)
      skin.thickness_at = [scale, given = skin.thickness_at](const auto v) {
        return scale * given(v);
      };
    add_facets(side,
               extract_shell(dof_handler, selection, skin, part, numbering),
               part);
  }


  template <int dim>
  void
  ContactInterface<dim>::begin_adding()
  {
    if (!is_set_up)
      return;
    is_set_up = false;
    obstacle.reset();
    rigid_bodies.clear();
    n_rigid_vertices = 0;
    for (auto &surface : surfaces)
      surface.rigid_bodies.clear();
  }


  template <int dim>
  void
  ContactInterface<dim>::set_friction_law(std::unique_ptr<FrictionLaw> own)
  {
    AssertThrow(!is_set_up,
                ExcMessage("Interface '" + name +
                           "': set_friction_law() comes before setup()."));
    AssertThrow(parameters.kind != ContactParameters::Kind::tied,
                ExcMessage("Interface '" + name +
                           "': a tied interface cannot slip."));
    friction = std::move(own);
  }


  template <int dim>
  void
  ContactInterface<dim>::build_surface(const unsigned int side)
  {
    AssertThrow(Utilities::MPI::sum(extracted[side].size(), communicator) > 0,
                ExcMessage("Interface '" + name + "' has no " +
                           side_names[side] + " surface: call add_" +
                           side_names[side] +
                           "() before setup(), which takes what was added "
                           "since the one before."));
    SurfaceStiffness stiffness;
    stiffness.modulus = parameters.modulus;
    stiffness.length  = parameters.explicit_length();
    stiffness.use_shortest_edge =
      parameters.characteristic_length == "shortest edge";
    stiffness.offset =
      (side == 0) ? parameters.secondary_offset : parameters.primary_offset;
    surfaces[side].build(extracted[side], stiffness, communicator);

    // rigid facets have neither modulus nor length
    InitialReport &initial = last_report.initial;
    initial.n_side_facets[side] =
      Utilities::MPI::sum(surfaces[side].skin.n_own, communicator);
    const auto range =
      [&](const std::vector<double> &values, double &lowest, double &highest) {
        lowest  = std::numeric_limits<double>::max();
        highest = 0.;
        for (const double v : values)
          if (v > 0.)
            {
              lowest  = std::min(lowest, v);
              highest = std::max(highest, v);
            }
        highest = Utilities::MPI::max(highest, communicator);
        lowest  = Utilities::MPI::min(lowest, communicator);
        if (highest == 0.)
          lowest = 0.;
      };
    range(surfaces[side].cell_modulus,
          initial.lowest_modulus[side],
          initial.highest_modulus[side]);
    range(surfaces[side].cell_length,
          initial.lowest_length[side],
          initial.highest_length[side]);
  }


  template <int dim>
  double
  ContactInterface<dim>::deepest_share() const
  {
    // a barrier ends a little before: half of the range is before the
    // stiffening, see PaperLaw
    return parameters.largest_share() *
           (parameters.release == ContactParameters::Release::never ?
              0.5 * (1. + PaperLaw::barrier_end) :
              1.);
  }


  template <int dim>
  void
  ContactInterface<dim>::setup()
  {
    // nothing of an earlier mesh must survive
    fetched_owned = IndexSet();
    for (auto &of_side : told)
      of_side.clear();
    pattern_is_current = false;
    last_report        = ContactReport();
    last_report.name   = name;

    committed_time       = 0.;
    last_time            = 0.;
    dissipation          = 0.;
    largest_tool_step    = 1.;
    has_committed_values = false;
    has_accepted_values  = false;

    const bool is_single =
      parameters.kind == ContactParameters::Kind::automatic_single_surface;
    const bool has_primary_facets =
      Utilities::MPI::sum(extracted[1].size(), communicator) > 0;
    AssertThrow(!obstacle || !has_primary_facets,
                ExcMessage(
                  "Interface '" + name + "': '" +
                  (obstacle ? obstacle->name : "") +
                  "' is a smooth surface and must be the only primary; "
                  "expected an interface of its own."));
    AssertThrow(!obstacle || parameters.primary_offset == 0.,
                ExcMessage("Interface '" + name +
                           "': 'Primary offset' is set but the primary is a "
                           "smooth surface; use 'Secondary offset'."));
    AssertThrow(!is_single || (!has_primary_facets && !obstacle),
                ExcMessage("Interface '" + name +
                           "' is a single surface: all its parts are "
                           "secondary; it has no primary."));
    AssertThrow(!parameters.has_ties() || !obstacle,
                ExcMessage("Interface '" + name + "': ties need facets; '" +
                           (obstacle ? obstacle->name : "") +
                           "' is a smooth surface."));
    for (const auto &body : rigid_bodies)
      if (!body->has_dofs())
        {
          body->move(0.);
          body->commit();
          body->move(0.);
        }
    build_surface(0);
    if (!is_single && !obstacle)
      build_surface(1);
    else
      surfaces[1] = ContactSurface<dim>();
    for (auto &surface : surfaces)
      surface.move([](const auto) { return 0.; });
    if (!rigid_bodies.empty() && !is_single && !obstacle &&
        !parameters.has_ties())
      check_tool_normals();
    for (auto &facets : extracted)
      facets.clear();
    AssertThrow(last_report.initial.highest_modulus[0] > 0. ||
                  last_report.initial.highest_modulus[1] > 0.,
                ExcMessage("Interface '" + name +
                           "': both sides are rigid; expected at least one "
                           "deformable body."));
    dofs = known_dofs();
    end_of_dofs =
      Utilities::MPI::max(dofs.empty() ? 0 : dofs.back() + 1, communicator);
    for (auto *state : {&values, &committed_values, &accepted_values})
      state->assign(dofs.size(), 0.);
    number_parts();

    KernelOptions options;
    options.integration    = parameters.integration;
    options.stiffness_side = parameters.side();
    options.symmetrise     = parameters.symmetric_tangent;
    options.elastic_slip   = parameters.friction.elastic_slip;
    options.tangential_scale =
      parameters.stiffness_scale * parameters.penalty_factor;
    // without facets there are no segments
    if (obstacle && options.integration.rule == Integration::Rule::segments)
      options.integration.rule = Integration::Rule::points;
    const unsigned int n_sweeps = obstacle ? 1 : parameters.n_sweeps();
    sweeps.clear();
    for (unsigned int i = 0; i < n_sweeps; ++i)
      sweeps.push_back(
        std::make_unique<ContactSweep<dim>>(surfaces[side_of(i, 0)].skin,
                                            surfaces[side_of(i, 1)].skin,
                                            obstacle ? obstacle->surface.get() :
                                                       nullptr,
                                            *law,
                                            friction.get(),
                                            options,
                                            is_single ? 0.5 : 1. / n_sweeps));
    tie_sweep.reset();
    if (parameters.has_ties())
      {
        TieStrength strength = parameters.tie.strength;
        if (parameters.kind == ContactParameters::Kind::tied)
          strength.law = TieStrength::Law::never;
        const PairKernel<dim> kernel(*law, nullptr, options);
        (void)bring_near([&]() {
          return std::vector<std::vector<Box<dim>>>{tie_regions(
            surfaces[0].skin, surfaces[1].skin, parameters.tie.tolerance)};
        });
        tie_sweep = std::make_unique<TieSweep<dim>>(surfaces[0].skin,
                                                    surfaces[1].skin,
                                                    strength,
                                                    kernel,
                                                    options.tangential_scale,
                                                    parameters.tie.tolerance);
        const TieCounts     ties  = tie_sweep->counts();
        std::vector<double> areas = {ties.area,
                                     ties.tied_area,
                                     double(ties.n_free_facets),
                                     ties.loose_area};
        Utilities::MPI::sum(areas, communicator, areas);
        InitialReport &initial = last_report.initial;
        initial.secondary_area = areas[0];
        initial.tied_area      = areas[1];
        initial.n_free_facets  = std::lround(areas[2]);
        initial.loose_area     = areas[3];
        const double brittle = Utilities::MPI::max(ties.brittle, communicator);
        AssertThrow(
          brittle < 1.,
          ExcMessage("Interface '" + name +
                     "': the elastic energy of the ties at their strength is " +
                     std::to_string(brittle) +
                     " times their fracture energy; nothing is left to "
                     "soften. Expected larger fracture energies, or a larger "
                     "'Normal tie stiffness' (CN)."));
        initial.largest_tied_gap =
          Utilities::MPI::max(ties.largest_gap, communicator);
        AssertThrow(initial.tied_area > 0.,
                    ExcMessage("Interface '" + name +
                               "': nothing is tied; no part of the secondary "
                               "lies within 'Tie tolerance', " +
                               std::to_string(parameters.tie.tolerance) +
                               ", of the primary (0: 5 % of each facet's "
                               "diameter)."));
        exclude_tied_facets();
      }
    detect_initial_penetrations();
    for (const auto &sweep : sweeps)
      sweep->start(removal_share(parameters.initial_penetration,
                                 0.,
                                 parameters.removal_time));
    evaluate(0., false);
    accepted_report = last_report;
    is_set_up       = true;
  }


  template <int dim>
  std::size_t
  ContactInterface<dim>::place_of(const types::global_dof_index dof) const
  {
    return std::lower_bound(dofs.begin(), dofs.end(), dof) - dofs.begin();
  }


  template <int dim>
  double
  ContactInterface<dim>::value(const types::global_dof_index dof) const
  {
    return values[place_of(dof)];
  }


  template <int dim>
  void
  ContactInterface<dim>::number_parts()
  {
    part_names.clear();
    std::map<std::string, unsigned int> numbers;
    const auto                          number = [&](const std::string &part) {
      const auto inserted = numbers.try_emplace(part, part_names.size());
      if (inserted.second)
        part_names.push_back(part);
      return inserted.first->second;
    };
    for (unsigned int side = 0; side < 2; ++side)
      {
        number_of_part[side].clear();
        for (const std::string &part : surfaces[side].parts)
          number_of_part[side].push_back(number(part));
      }
    if (obstacle)
      part_of_obstacle = number(obstacle->name);
  }


  template <int dim>
  void
  ContactInterface<dim>::evaluate_sweeps(const double share,
                                         const double time,
                                         const bool   with_tangent)
  {
    for (unsigned int i = 0; i < sweeps.size(); ++i)
      {
        sweeps[i]->evaluate(share, time - committed_time, with_tangent);
        sweeps[i]->set_aside(pairs_behind(*sweeps[i], i));
      }
    if (tie_sweep)
      tie_sweep->evaluate(with_tangent);
  }


  template <int dim>
  void
  ContactInterface<dim>::evaluate(const double time, const bool with_tangent)
  {
    Timer timer;
    bool  search = false;
    for (const auto &sweep : sweeps)
      search = search || sweep->needs_search();
    if (Utilities::MPI::logical_or(search, communicator))
      {
        bring_candidates_near();
        bool changed = false;
        coupled.resize(sweeps.size());
        for (unsigned int i = 0; i < sweeps.size(); ++i)
          {
            sweeps[i]->search();
            changed = changed || !std::includes(coupled[i].begin(),
                                                coupled[i].end(),
                                                sweeps[i]->candidates().begin(),
                                                sweeps[i]->candidates().end());
          }
        if (Utilities::MPI::logical_or(changed, communicator))
          {
            pattern_is_current            = false;
            last_report.couplings_changed = true;
          }
      }
    last_report.search_seconds +=
      Utilities::MPI::max(timer.wall_time(), communicator);

    timer.restart();
    const double share = removal_share(parameters.initial_penetration,
                                       time,
                                       parameters.removal_time);
    evaluate_sweeps(share, time, with_tangent);
    make_report();
    last_report.evaluate_seconds +=
      Utilities::MPI::max(timer.wall_time(), communicator);
  }


  template <int dim>
  void
  ContactInterface<dim>::commit(const double time)
  {
    // contact of these would be lost without a trace
    AssertThrow(is_finite &&
                  (last_report.n_too_deep == 0 ||
                   parameters.release != ContactParameters::Release::cut_back),
                ExcMessage("commit() of a state that advice() refuses: " +
                           advice().reason));
    AssertThrow(time == last_time,
                ExcMessage("Interface '" + name + "': commit() at time " +
                           std::to_string(time) +
                           ", but the last update() was at " +
                           std::to_string(last_time) + "."));
    unsigned int n_released = 0;
    for (const auto &sweep : sweeps)
      {
        std::vector<unsigned int> released;
        if (parameters.release == ContactParameters::Release::report)
          released = sweep->too_deep(deepest_share());
        n_released += released.size();
        sweep->commit(parameters.initial_penetration ==
                        InitialPenetration::track,
                      released);
      }
    last_report.n_released += Utilities::MPI::sum(n_released, communicator);
    if (tie_sweep)
      {
        tie_sweep->commit();
        exclude_tied_facets();
      }
    for (const auto &body : rigid_bodies)
      body->commit();
    dissipation                 = last_report.dissipation;
    committed_time              = time;
    committed_values            = values;
    accepted_values             = values;
    has_committed_values        = true;
    has_accepted_values         = true;
    last_report.n_augmentations = 0;
    accepted_report             = last_report;
  }


  template <int dim>
  void
  ContactInterface<dim>::exclude_tied_facets()
  {
    if (sweeps.empty())
      return;
    const std::vector<char> held = tie_sweep->holds();
    sweeps[0]->set_tied(held);
    // the other sweep's points look at facets that are tied: they have no
    // contact either
    std::map<unsigned int, std::vector<unsigned int>> tied_primary;
    for (const auto &[s, p] : tie_sweep->candidates())
      if (held[s])
        {
          const auto [rank, number] = surfaces[1].origin(p);
          tied_primary[rank].push_back(number);
        }
    std::vector<char> is_held(surfaces[1].skin.n_own, false);
    for (const auto &[rank, facets] :
         Utilities::MPI::some_to_some(communicator, tied_primary))
      for (const unsigned int f : facets)
        is_held[f] = true;
    sweeps[1]->set_tied(is_held);
  }


  template <int dim>
  bool
  ContactInterface<dim>::augment()
  {
    if (!parameters.augmentation.is_on)
      return false;
    double depth = 0.;
    for (const auto &sweep : sweeps)
      depth = std::max(depth, sweep->penetration());
    if (Utilities::MPI::max(depth, communicator) <=
        parameters.augmentation.tolerance)
      {
        is_augmented = true;
        return false;
      }
    is_augmented = false;
    if (last_report.n_augmentations >= parameters.augmentation.most)
      return false;
    for (const auto &sweep : sweeps)
      sweep->augment();
    ++last_report.n_augmentations;
    ++last_report.n_augmentations_total;
    return true;
  }


  template <int dim>
  void
  ContactInterface<dim>::rollback()
  {
    // Other trial quantities live in the last evaluation only; the next
    // update() replaces it.
    for (const auto &sweep : sweeps)
      sweep->rollback();
    last_time = committed_time;

    // what was spent, and the pattern, are not undone
    ContactReport accepted         = accepted_report;
    accepted.search_seconds        = last_report.search_seconds;
    accepted.evaluate_seconds      = last_report.evaluate_seconds;
    accepted.n_augmentations_total = last_report.n_augmentations_total;
    accepted.couplings_changed     = last_report.couplings_changed;
    last_report                    = accepted;
  }


  template class ContactInterface<2>;
  template class ContactInterface<3>;
} // namespace MortarContact
