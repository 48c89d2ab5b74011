// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/host/contact_interface.h>
#include <mortar_contact/laws/law_library.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/array.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

namespace MortarContact
{
  namespace
  {
    const char *const side_names[2] = {"secondary", "primary"};

    template <int dim>
    Tensor<1, 3>
    in_space(const Tensor<1, dim> &v)
    {
      Tensor<1, 3> result;
      for (unsigned int i = 0; i < dim; ++i)
        result[i] = v[i];
      return result;
    }

    /// Vertex components of a pair's residual as vectors, with the positions.
    template <int dim, class Function>
    void
    for_each_force(const Skin<dim>                              &secondary,
                   const Skin<dim>                              &primary,
                   const typename ContactSweep<dim>::ActivePair &pair,
                   const Function                               &function)
    {
      for (unsigned int side = 0; side < 2; ++side)
        {
          const Facet<dim> &facet = (side == 0) ?
                                      secondary.facets[pair.secondary].current :
                                      primary.facets[pair.primary].current;
          for (unsigned int a = 0; a < facet.n_vertices; ++a)
            {
              Tensor<1, dim> force;
              for (unsigned int i = 0; i < dim; ++i)
                force[i] =
                  -pair.block
                     .residual[side * max_facet_components<dim> + a * dim + i];
              function(side, in_space(facet.x[a]), in_space(force));
            }
        }
    }
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
                        parameters.largest_share());
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
    const std::vector<SurfaceFacet<dim>> facets =
      extract_surface<dim>(dof_handler,
                           mapping,
                           selection,
                           modulus_of_cell,
                           part,
                           numbering,
                           first_component,
                           communicator);
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
  ContactInterface<dim>::build_surface(const unsigned int side)
  {
    AssertThrow(Utilities::MPI::sum(extracted[side].size(), communicator) > 0,
                ExcMessage("Interface '" + name + "' has no " +
                           side_names[side] + " surface: call add_" +
                           side_names[side] + "() before setup()."));
    SurfaceStiffness stiffness;
    stiffness.modulus = parameters.modulus;
    stiffness.length  = parameters.explicit_length();
    stiffness.use_shortest_edge =
      parameters.characteristic_length == "shortest edge";
    stiffness.offset =
      (side == 0) ? parameters.secondary_offset : parameters.primary_offset;
    surfaces[side].build(std::move(extracted[side]), stiffness, communicator);
    extracted[side].clear();

    InitialReport &initial        = last_report.initial;
    const auto    &K              = surfaces[side].cell_modulus;
    const auto    &l              = surfaces[side].cell_length;
    initial.n_side_facets[side]   = K.size();
    initial.lowest_modulus[side]  = *std::min_element(K.begin(), K.end());
    initial.highest_modulus[side] = *std::max_element(K.begin(), K.end());
    initial.lowest_length[side]   = *std::min_element(l.begin(), l.end());
    initial.highest_length[side]  = *std::max_element(l.begin(), l.end());
  }


  template <int dim>
  void
  ContactInterface<dim>::setup()
  {
    // nothing of an earlier mesh must survive
    partitioner.reset();
    fetched_owned      = IndexSet();
    pattern_is_current = false;
    last_report        = ContactReport();
    last_report.name   = name;

    for (unsigned int side = 0; side < 2; ++side)
      build_surface(side);
    dofs              = surfaces[0].dofs();
    const auto others = surfaces[1].dofs();
    dofs.insert(dofs.end(), others.begin(), others.end());
    std::sort(dofs.begin(), dofs.end());
    dofs.erase(std::unique(dofs.begin(), dofs.end()), dofs.end());
    values.assign(dofs.size(), 0.);

    KernelOptions options;
    options.integration    = parameters.integration;
    options.stiffness_side = parameters.side();
    options.symmetrise     = parameters.symmetric_tangent;
    const unsigned int n_sweeps =
      (parameters.kind ==
       ContactParameters::Kind::automatic_surface_to_surface) ?
        2 :
        1;
    sweeps.clear();
    for (unsigned int i = 0; i < n_sweeps; ++i)
      sweeps.push_back(std::make_unique<ContactSweep<dim>>(
        surfaces[i].skin, surfaces[1 - i].skin, *law, options, 1. / n_sweeps));
    detect_initial_penetrations();
    evaluate(0., false);
  }


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

    std::vector<DeepPenetration> deepest, undetected;
    for (unsigned int i = 0; i < sweeps.size(); ++i)
      {
        const InitialFindings<dim> found = sweeps[i]->detect_initial(treatment);
        const auto                &labels = surfaces[i].labels;
        initial.n_facets += Utilities::MPI::sum(found.n_facets, communicator);
        initial.n_undetected +=
          Utilities::MPI::sum(found.n_too_deep, communicator);
        if (found.n_facets > 0)
          deepest.push_back(
            {found.depth,
             found.depth /
               (treatment.largest_share * surfaces[i].cell_length[found.facet]),
             labels[found.facet],
             {},
             in_space(found.position)});
        if (found.n_too_deep > 0)
          undetected.push_back(
            {found.too_deep,
             found.too_deep / (treatment.largest_share *
                               surfaces[i].cell_length[found.too_deep_facet]),
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
  IndexSet
  ContactInterface<dim>::relevant_dofs(
    const types::global_dof_index n_dofs) const
  {
    IndexSet result(n_dofs);
    result.add_indices(dofs.begin(), dofs.end());
    result.compress();
    return result;
  }


  template <int dim>
  double
  ContactInterface<dim>::value(const types::global_dof_index dof) const
  {
    return values[std::lower_bound(dofs.begin(), dofs.end(), dof) -
                  dofs.begin()];
  }


  template <int dim>
  void
  ContactInterface<dim>::fetch_owned(const IndexSet            &owned,
                                     const std::vector<double> &owned_values)
  {
    const bool is_new = !partitioner || owned.size() != fetched_owned.size() ||
                        !(owned == fetched_owned);
    if (Utilities::MPI::logical_or(is_new, communicator))
      {
        fetched_owned = owned;
        partitioner =
          std::make_unique<Utilities::MPI::NoncontiguousPartitioner>(
            owned, relevant_dofs(owned.size()), communicator);
      }
    partitioner->template export_to_ghosted_array<double>(
      ArrayView<const double>(owned_values.data(), owned_values.size()),
      ArrayView<double>(values.data(), values.size()));
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
        bool changed = false;
        for (const auto &sweep : sweeps)
          {
            const auto before = sweep->candidates();
            sweep->search();
            changed = changed || !std::includes(before.begin(),
                                                before.end(),
                                                sweep->candidates().begin(),
                                                sweep->candidates().end());
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
    for (const auto &sweep : sweeps)
      sweep->evaluate(share, with_tangent);
    make_report();
    last_report.evaluate_seconds +=
      Utilities::MPI::max(timer.wall_time(), communicator);
  }


  template <int dim>
  void
  ContactInterface<dim>::make_report()
  {
    ContactReport &r = last_report;
    // Step 1: sums and maxima of this rank.
    std::vector<double> sums(16, 0.), maxima(4, 0.);
    maxima[2] = std::numeric_limits<double>::lowest();
    std::vector<DeepPenetration> worst;
    for (unsigned int i = 0; i < sweeps.size(); ++i)
      {
        const ContactSweep<dim> &sweep   = *sweeps[i];
        const auto              &counts  = sweep.counts();
        const double             added[] = {
                      double(sweep.candidates().size()),
                      double(counts.active),
                      double(counts.open),
                      double(counts.apart),
                      double(counts.beyond),
                      double(counts.degenerate),
                      double(sweep.too_deep(parameters.largest_share()).size())};
        for (unsigned int k = 0; k < 7; ++k)
          sums[k] += added[k];
        maxima[2] = std::max(maxima[2], -counts.smallest_gap);
        maxima[3] = std::max(maxima[3], counts.overlap);
        for (const auto &pair : sweep.active_pairs())
          {
            const PairBlock<dim> &block = pair.block;
            sums[7] += block.active_area;
            sums[8] += block.energy;
            sums[9] += block.penetration_volume;
            for_each_force(surfaces[i].skin,
                           surfaces[1 - i].skin,
                           pair,
                           [&](const unsigned int  side,
                               const Tensor<1, 3> &x,
                               const Tensor<1, 3> &force) {
                             if (side != i) // body 0: side i of sweep i
                               return;
                             const Tensor<1, 3> moment =
                               cross_product_3d(x, force);
                             for (unsigned int c = 0; c < 3; ++c)
                               {
                                 sums[10 + c] += force[c];
                                 sums[13 + c] += moment[c];
                               }
                           });
            const double relative =
              block.relative_penetration / parameters.largest_share();
            maxima[0] = std::max(maxima[0], block.penetration);
            maxima[1] = std::max(maxima[1], relative);
            worst.push_back({block.penetration,
                             relative,
                             surfaces[i].labels[pair.secondary],
                             surfaces[1 - i].labels[pair.primary],
                             in_space(block.deepest_position)});
          }
      }

    // Step 2: over the ranks.
    Utilities::MPI::sum(sums, communicator, sums);
    Utilities::MPI::max(maxima, communicator, maxima);
    r.candidate_pairs  = std::lround(sums[0]);
    r.active_pairs     = std::lround(sums[1]);
    r.open_pairs       = std::lround(sums[2]);
    r.apart_pairs      = std::lround(sums[3]);
    r.beyond_pairs     = std::lround(sums[4]);
    r.degenerate_pairs = std::lround(sums[5]);
    r.n_too_deep       = std::lround(sums[6]);
    r.active_area      = sums[7];
    r.energy           = sums[8];
    r.mean_penetration = sums[7] > 0. ? sums[9] / sums[7] : 0.;
    for (unsigned int c = 0; c < 3; ++c)
      {
        r.force[c]  = sums[10 + c];
        r.moment[c] = sums[13 + c];
      }
    r.largest_penetration  = maxima[0];
    r.relative_penetration = maxima[1];
    r.smallest_gap         = -maxima[2];
    r.largest_overlap      = maxima[3];

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
    for (const auto &of_rank : Utilities::MPI::all_gather(communicator, worst))
      r.worst.insert(r.worst.end(), of_rank.begin(), of_rank.end());
    keep_worst(r.worst);
  }


  template <int dim>
  StepAdvice
  ContactInterface<dim>::advice() const
  {
    StepAdvice advice;
    if (last_report.n_too_deep > 0 &&
        parameters.release == ContactParameters::Release::cut_back)
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
  void
  ContactInterface<dim>::commit(const double)
  {
    unsigned int n_released = 0;
    for (const auto &sweep : sweeps)
      {
        std::vector<unsigned int> released;
        if (parameters.release == ContactParameters::Release::report)
          released = sweep->too_deep(parameters.largest_share());
        n_released += released.size();
        sweep->commit(parameters.initial_penetration ==
                        InitialPenetration::track,
                      released);
      }
    last_report.n_released += Utilities::MPI::sum(n_released, communicator);
  }


  template <int dim>
  void
  ContactInterface<dim>::rollback()
  {
    // Trial quantities live in the last evaluation only; the next update()
    // replaces it.
  }


  template <int dim>
  const SurfaceVertex<dim> &
  ContactInterface<dim>::vertex_of(const unsigned int sweep,
                                   const unsigned int s,
                                   const unsigned int p,
                                   const unsigned int a) const
  {
    constexpr unsigned int n = max_vertices<dim>;
    return (a < n) ? surfaces[sweep].vertex(s, a) :
                     surfaces[1 - sweep].vertex(p, a - n);
  }


  namespace
  {
    /// Whether vertex @p a of a pair, counted as in PairVector, exists.
    template <int dim>
    bool
    exists(const ContactFacet<dim> &s,
           const ContactFacet<dim> &p,
           const unsigned int       a)
    {
      constexpr unsigned int n = max_vertices<dim>;
      return (a < n) ? a < s.current.n_vertices : a - n < p.current.n_vertices;
    }
  } // namespace


  template <int dim>
  std::vector<types::global_dof_index>
  ContactInterface<dim>::dofs_of(const unsigned int sweep,
                                 const unsigned int s,
                                 const unsigned int p) const
  {
    std::vector<types::global_dof_index> result;
    for (unsigned int a = 0; a < 2 * max_vertices<dim>; ++a)
      if (exists(surfaces[sweep].skin.facets[s],
                 surfaces[1 - sweep].skin.facets[p],
                 a))
        for (const auto &entry : vertex_of(sweep, s, p, a).row)
          result.insert(result.end(), entry.dofs.begin(), entry.dofs.end());
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }


  template <int dim>
  void
  ContactInterface<dim>::distribute_pair(
    const unsigned int                            sweep,
    const typename ContactSweep<dim>::ActivePair &pair,
    const bool                                    with_tangent,
    std::vector<types::global_dof_index>         &pair_dofs,
    Vector<double>                               &forces,
    FullMatrix<double>                           &tangent) const
  {
    pair_dofs = dofs_of(sweep, pair.secondary, pair.primary);
    forces.reinit(pair_dofs.size());
    if (with_tangent)
      tangent.reinit(pair_dofs.size(), pair_dofs.size());

    // The rows of the vertex map: component by component.
    struct Term
    {
      unsigned int component; ///< As in PairVector.
      unsigned int dof;       ///< In pair_dofs.
      double       weight;
    };
    std::vector<Term> terms;
    for (unsigned int a = 0; a < 2 * max_vertices<dim>; ++a)
      if (exists(surfaces[sweep].skin.facets[pair.secondary],
                 surfaces[1 - sweep].skin.facets[pair.primary],
                 a))
        for (const auto &entry :
             vertex_of(sweep, pair.secondary, pair.primary, a).row)
          for (unsigned int i = 0; i < dim; ++i)
            terms.push_back(
              {a * dim + i,
               static_cast<unsigned int>(std::lower_bound(pair_dofs.begin(),
                                                          pair_dofs.end(),
                                                          entry.dofs[i]) -
                                         pair_dofs.begin()),
               entry.weight});

    for (const Term &row : terms)
      {
        forces(row.dof) -= row.weight * pair.block.residual[row.component];
        if (with_tangent)
          for (const Term &column : terms)
            tangent(row.dof, column.dof) +=
              row.weight * column.weight *
              pair.block.tangent[row.component][column.component];
      }
  }


  template <int dim>
  void
  ContactInterface<dim>::save(std::ostream &out) const
  {
    boost::archive::binary_oarchive archive(out);
    const unsigned int              n = sweeps.size();
    archive << n << last_report.n_released;
    for (const auto &sweep : sweeps)
      archive << sweep->state();
  }


  template <int dim>
  void
  ContactInterface<dim>::load(std::istream &in)
  {
    boost::archive::binary_iarchive archive(in);
    unsigned int                    n = 0;
    archive >> n >> last_report.n_released;
    AssertThrow(n == sweeps.size(),
                ExcMessage("The saved state belongs to another interface."));
    for (const auto &sweep : sweeps)
      {
        ContactHistory<dim> history;
        archive >> history;
        sweep->restore(history);
      }
  }


  template <int dim>
  double
  ContactInterface<dim>::check_balance() const
  {
    std::vector<double> sums(8, 0.);
    for (unsigned int i = 0; i < sweeps.size(); ++i)
      for (const auto &pair : sweeps[i]->active_pairs())
        for_each_force(surfaces[i].skin,
                       surfaces[1 - i].skin,
                       pair,
                       [&](const unsigned int,
                           const Tensor<1, 3> &x,
                           const Tensor<1, 3> &force) {
                         const Tensor<1, 3> moment = cross_product_3d(x, force);
                         for (unsigned int c = 0; c < 3; ++c)
                           {
                             sums[c] += force[c];
                             sums[3 + c] += moment[c];
                           }
                         sums[6] += force.norm();
                         sums[7] += x.norm() * force.norm();
                       });
    Utilities::MPI::sum(sums, communicator, sums);
    const auto share =
      [](const double x, const double y, const double z, const double of) {
        return of > 0. ? std::sqrt(x * x + y * y + z * z) / of : 0.;
      };
    return std::max(share(sums[0], sums[1], sums[2], sums[6]),
                    share(sums[3], sums[4], sums[5], sums[7]));
  }


  template <int dim>
  double
  ContactInterface<dim>::check_tangent_at_fetched(const double       time,
                                                  const unsigned int n_samples)
  {
    const std::vector<double> base = values;
    const double share = removal_share(parameters.initial_penetration,
                                       time,
                                       parameters.removal_time);
    double       size  = 0.;
    for (const auto &facet : surfaces[0].skin.facets)
      size = std::max(size, diameter(facet.reference));
    size = Utilities::MPI::max(size, communicator);

    // contact forces, and tangent times a direction
    const auto evaluate_at = [&](const std::vector<double> &at,
                                 const bool                 with_tangent) {
      values = at;
      for (auto &surface : surfaces)
        surface.move([&](const auto dof) { return value(dof); });
      for (const auto &sweep : sweeps)
        sweep->evaluate(share, with_tangent);
    };
    const auto collect = [&](const std::vector<double> *direction) {
      std::vector<double>                  result(dofs.size(), 0.);
      std::vector<types::global_dof_index> pair_dofs;
      Vector<double>                       forces;
      FullMatrix<double>                   tangent;
      for (unsigned int i = 0; i < sweeps.size(); ++i)
        for (const auto &pair : sweeps[i]->active_pairs())
          {
            distribute_pair(
              i, pair, direction != nullptr, pair_dofs, forces, tangent);
            const auto index = [&](const unsigned int k) {
              return std::lower_bound(dofs.begin(), dofs.end(), pair_dofs[k]) -
                     dofs.begin();
            };
            for (unsigned int r = 0; r < pair_dofs.size(); ++r)
              if (direction == nullptr)
                result[index(r)] -= forces(r);
              else
                for (unsigned int c = 0; c < pair_dofs.size(); ++c)
                  result[index(r)] += tangent(r, c) * (*direction)[index(c)];
          }
      Utilities::MPI::sum(result, communicator, result);
      return result;
    };

    std::mt19937                           random(1);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    double                                 worst = 0.;
    for (unsigned int sample = 0; sample < n_samples; ++sample)
      {
        std::vector<double> direction(dofs.size());
        for (double &d : direction)
          d = uniform(random);
        evaluate_at(base, true);
        const std::vector<double> exact = collect(&direction);
        double                    best  = std::numeric_limits<double>::max();
        for (const double h : {1e-4, 1e-5, 1e-6, 1e-7})
          {
            const auto moved_by = [&](const double by) {
              std::vector<double> at = base;
              for (std::size_t i = 0; i < at.size(); ++i)
                at[i] += by * size * direction[i];
              evaluate_at(at, false);
              return collect(nullptr);
            };
            const std::vector<double> plus = moved_by(h), minus = moved_by(-h);
            double                    error = 0., scale = 0.;
            for (std::size_t i = 0; i < exact.size(); ++i)
              {
                const double difference =
                  (plus[i] - minus[i]) / (2. * h * size);
                error = std::max(error, std::abs(difference - exact[i]));
                scale = std::max(scale, std::abs(exact[i]));
              }
            if (scale > 0.)
              best = std::min(best, error / scale);
            else
              best = error;
          }
        worst = std::max(worst, best);
      }
    evaluate_at(base, true);
    return worst;
  }


  template class ContactInterface<2>;
  template class ContactInterface<3>;
} // namespace MortarContact
