// SPDX-License-Identifier: LGPL-2.1-or-later

// What ContactInterface gets from other ranks: values of dofs, and facets that
// come near. No rank knows a whole surface.

#include <mortar_contact/host/contact_interface.h>

#include <deal.II/base/mpi.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace MortarContact
{
  namespace
  {
    /// Boxes by which a rank tells the others where it looks: more hold less
    /// that is not near.
    constexpr unsigned int n_boxes = 32;

    using Dofs = std::vector<types::global_dof_index>;

    /// Tell the owners of dofs that this rank wants to know them.
    /// @return What other ranks want to know of this one.
    std::map<unsigned int, Dofs>
    ask_owners(const IndexSet               &owned,
               const Dofs                   &dofs,
               std::map<unsigned int, Dofs> &asked,
               const MPI_Comm                communicator)
    {
      IndexSet wanted(owned.size());
      wanted.add_indices(dofs.begin(), dofs.end());
      const std::vector<unsigned int> owners =
        Utilities::MPI::compute_index_owner(owned, wanted, communicator);
      for (std::size_t i = 0; i < dofs.size(); ++i)
        asked[owners[i]].push_back(dofs[i]);
      return Utilities::MPI::some_to_some(communicator, asked);
    }
  } // namespace


  template <int dim>
  std::vector<types::global_dof_index>
  ContactInterface<dim>::known_dofs() const
  {
    Dofs result = surfaces[0].dofs();
    for (const auto dof : surfaces[1].dofs())
      result.push_back(dof);
    for (const auto &body : rigid_bodies)
      result.insert(result.end(), body->dofs().begin(), body->dofs().end());
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }


  template <int dim>
  IndexSet
  ContactInterface<dim>::relevant_dofs(
    const types::global_dof_index n_dofs) const
  {
    // numbers only: what comes near later is relevant, too
    IndexSet result(n_dofs);
    result.add_indices(dofs.begin(), dofs.end());
    result.compress();
    for (const IndexSet &of_rank :
         Utilities::MPI::all_gather(communicator, result))
      result.add_indices(of_rank);
    result.compress();
    return result;
  }


  template <int dim>
  IndexSet
  ContactInterface<dim>::active_dofs(const IndexSet &owned) const
  {
    Dofs active;
    for_each_pair([&](const unsigned int sweep, const auto &pair) {
      for (const auto dof : dofs_of(sweep, pair.secondary, pair.primary))
        active.push_back(dof);
    });
    std::sort(active.begin(), active.end());
    active.erase(std::unique(active.begin(), active.end()), active.end());
    std::map<unsigned int, Dofs> asked;
    IndexSet                     result(owned.size());
    for (auto &[rank, of_rank] : ask_owners(owned, active, asked, communicator))
      result.add_indices(of_rank.begin(), of_rank.end());
    result.compress();
    return result;
  }


  template <int dim>
  void
  ContactInterface<dim>::prepare_fetch(const IndexSet &owned)
  {
    const bool is_new = fetched != dofs ||
                        owned.size() != fetched_owned.size() ||
                        !(owned == fetched_owned);
    if (!Utilities::MPI::logical_or(is_new, communicator))
      return;
    fetched_owned = owned;
    fetched       = dofs;
    places.clear();
    std::map<unsigned int, Dofs> asked;
    asked_of_me = ask_owners(owned, dofs, asked, communicator);
    for (const auto &[rank, of_rank] : asked)
      for (const auto dof : of_rank)
        places[rank].push_back(place_of(dof));
  }


  template <int dim>
  void
  ContactInterface<dim>::exchange(
    const std::map<unsigned int, std::vector<double>> &answers)
  {
    for (const auto &[rank, received] :
         Utilities::MPI::some_to_some(communicator, answers))
      for (std::size_t i = 0; i < received.size(); ++i)
        values[places[rank][i]] = received[i];
    const bool is_wrong =
      std::any_of(values.begin(), values.end(), [](const double v) {
        return !std::isfinite(v);
      });
    is_finite = !Utilities::MPI::logical_or(is_wrong, communicator);
  }


  template <int dim>
  std::vector<Box<dim>>
  ContactInterface<dim>::own_boxes(const unsigned int side) const
  {
    const Skin<dim>      &skin = surfaces[side].skin;
    std::vector<Box<dim>> boxes;
    boxes.reserve(skin.n_own);
    for (unsigned int f = 0; f < skin.n_own; ++f)
      boxes.push_back(box_around(skin.facets[f].current));
    return boxes;
  }


  template <int dim>
  bool
  ContactInterface<dim>::bring_near(
    const std::function<std::vector<std::vector<Box<dim>>>()>   &regions,
    const std::function<std::array<std::vector<Box<dim>>, 2>()> &boxes,
    const std::vector<std::vector<double> *>                    &more_states)
  {
    const unsigned int rank    = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    if (n_ranks == 1 || obstacle)
      return false;
    std::vector<std::vector<double> *> states = more_states;
    for (auto *state : {&values, &committed_values, &accepted_values})
      states.push_back(state);

    // Step 1: where all ranks look.
    std::vector<std::vector<Box<dim>>> coarse;
    for (const auto &of_sweep : regions())
      coarse.push_back(join(of_sweep, n_boxes));
    const auto looked_at = Utilities::MPI::all_gather(communicator, coarse);

    // Step 2: this rank's facets that lie there and are not known there.
    using Message = std::array<std::vector<NearFacet<dim>>, 2>;
    std::map<unsigned int, Message>      messages;
    std::array<std::vector<Box<dim>>, 2> own;
    if (boxes)
      own = boxes();
    else
      own = {{own_boxes(0), own_boxes(1)}};
    for (unsigned int i = 0; i < coarse.size(); ++i)
      {
        const unsigned int side = side_of(i, 1);
        if (own[side].empty())
          continue;
        const BroadPhase<dim> broad_phase(own[side]);
        for (unsigned int r = 0; r < n_ranks; ++r)
          for (const Box<dim> &box : looked_at[r][i])
            if (r != rank)
              for (const unsigned int f : broad_phase.find(box))
                if (told[side][r].insert(f).second)
                  {
                    NearFacet<dim> near = surfaces[side].describe(f);
                    for (const auto *state : states)
                      for (unsigned int a = 0; a < near.facet.n_vertices; ++a)
                        for (const auto &entry : near.facet.vertices[a].row)
                          for (const auto dof : entry.dofs)
                            near.values.push_back((*state)[place_of(dof)]);
                    if (i < sweeps.size() &&
                        !sweeps[i]->state().before[1].empty())
                      near.before.push_back(sweeps[i]->state().before[1][f]);
                    messages[r][side].push_back(near);
                  }
      }
    const auto received = Utilities::MPI::some_to_some(communicator, messages);

    // Step 3: take over those of the others, and what is known of their dofs.
    std::map<types::global_dof_index, std::vector<double>> news;
    for (const auto &[r, message] : received)
      for (unsigned int side = 0; side < 2; ++side)
        {
          std::vector<Facet<dim>> before;
          for (const NearFacet<dim> &near : message[side])
            {
              surfaces[side].add(near, r);
              before.insert(before.end(),
                            near.before.begin(),
                            near.before.end());
              std::size_t       next = 0;
              const std::size_t n    = near.values.size() / states.size();
              for (unsigned int a = 0; a < near.facet.n_vertices; ++a)
                for (const auto &entry : near.facet.vertices[a].row)
                  for (const auto dof : entry.dofs)
                    {
                      auto &of_dof = news[dof];
                      of_dof.clear();
                      for (std::size_t s = 0; s < states.size(); ++s)
                        of_dof.push_back(near.values[s * n + next]);
                      ++next;
                    }
            }
          for (unsigned int i = 0; i < sweeps.size(); ++i)
            if (side_of(i, 1) == side)
              sweeps[i]->remember_primary(before);
        }
    if (received.empty())
      return false;
    const Dofs          old = std::exchange(dofs, known_dofs());
    std::vector<double> extended(dofs.size());
    for (std::size_t s = 0; s < states.size(); ++s)
      {
        std::size_t next = 0;
        for (std::size_t k = 0; k < dofs.size(); ++k)
          extended[k] = (next < old.size() && old[next] == dofs[k]) ?
                          (*states[s])[next++] :
                          news.at(dofs[k])[s];
        *states[s] = extended;
      }
    return true;
  }


  template <int dim>
  void
  ContactInterface<dim>::bring_candidates_near()
  {
    (void)bring_near([&]() {
      std::vector<std::vector<Box<dim>>> regions;
      for (const auto &sweep : sweeps)
        regions.push_back(sweep->regions(coupled_motion));
      return regions;
    });
  }


  template std::vector<types::global_dof_index>
  ContactInterface<2>::known_dofs() const;
  template IndexSet
  ContactInterface<2>::relevant_dofs(const types::global_dof_index) const;
  template IndexSet
  ContactInterface<2>::active_dofs(const IndexSet &) const;
  template void
  ContactInterface<2>::prepare_fetch(const IndexSet &);
  template void
  ContactInterface<2>::exchange(
    const std::map<unsigned int, std::vector<double>> &);
  template std::vector<Box<2>>
  ContactInterface<2>::own_boxes(const unsigned int) const;
  template bool
  ContactInterface<2>::bring_near(
    const std::function<std::vector<std::vector<Box<2>>>()> &,
    const std::function<std::array<std::vector<Box<2>>, 2>()> &,
    const std::vector<std::vector<double> *> &);
  template void
  ContactInterface<2>::bring_candidates_near();
  template std::vector<types::global_dof_index>
  ContactInterface<3>::known_dofs() const;
  template IndexSet
  ContactInterface<3>::relevant_dofs(const types::global_dof_index) const;
  template IndexSet
  ContactInterface<3>::active_dofs(const IndexSet &) const;
  template void
  ContactInterface<3>::prepare_fetch(const IndexSet &);
  template void
  ContactInterface<3>::exchange(
    const std::map<unsigned int, std::vector<double>> &);
  template std::vector<Box<3>>
  ContactInterface<3>::own_boxes(const unsigned int) const;
  template bool
  ContactInterface<3>::bring_near(
    const std::function<std::vector<std::vector<Box<3>>>()> &,
    const std::function<std::array<std::vector<Box<3>>, 2>()> &,
    const std::vector<std::vector<double> *> &);
  template void
  ContactInterface<3>::bring_candidates_near();
} // namespace MortarContact
