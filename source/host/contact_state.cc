// SPDX-License-Identifier: LGPL-2.1-or-later

// How ContactInterface is saved and continued.

#include <mortar_contact/host/contact_interface.h>

#include <deal.II/base/mpi.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <algorithm>
#include <string>

namespace MortarContact
{
  namespace
  {
    /// What save() begins with.
    const std::string saved_state = "MortarContact state 1\n";

    /// Join what all ranks remember; the same on all ranks.
    template <int dim>
    SurfaceHistory<dim>
    of_all_ranks(const SurfaceHistory<dim> &local, const MPI_Comm communicator)
    {
      SurfaceHistory<dim> all;
      all.share = local.share;
      for (const SurfaceHistory<dim> &of_rank :
           Utilities::MPI::all_gather(communicator, local))
        {
          all.facets.insert(all.facets.end(),
                            of_rank.facets.begin(),
                            of_rank.facets.end());
          all.aside.insert(all.aside.end(),
                           of_rank.aside.begin(),
                           of_rank.aside.end());
          all.has_levels   = all.has_levels || of_rank.has_levels;
          all.has_releases = all.has_releases || of_rank.has_releases;
          all.has_slip     = all.has_slip || of_rank.has_slip;
          all.has_augmentation =
            all.has_augmentation || of_rank.has_augmentation;
        }
      return all;
    }
  } // namespace


  template <int dim>
  void
  ContactInterface<dim>::save(std::ostream &out) const
  {
    out << saved_state;
    boost::archive::binary_oarchive archive(out);
    const unsigned int              n        = sweeps.size();
    const bool                      has_ties = tie_sweep != nullptr;
    archive << n << has_ties << last_report.n_released
            << last_report.n_augmentations_total << committed_time
            << dissipation;
    for (const auto &sweep : sweeps)
      {
        const auto history =
          of_all_ranks(sweep->surface_history(Utilities::MPI::logical_or(
                         sweep->remembers(), communicator)),
                       communicator);
        archive << history;
      }
    for (const auto &body : rigid_bodies)
      archive << *body;
    if (has_ties)
      {
        TiesHistory<dim> all;
        for (const auto &of_rank :
             Utilities::MPI::all_gather(communicator, tie_sweep->history()))
          {
            all.ties.insert(all.ties.end(),
                            of_rank.ties.begin(),
                            of_rank.ties.end());
            all.dissipated += of_rank.dissipated;
          }
        const TiesHistory<dim> &saved = all;
        archive << saved;
      }
  }


  template <int dim>
  void
  ContactInterface<dim>::load_at_fetched(std::istream &in)
  {
    unsigned int                     n        = 0;
    bool                             has_ties = false;
    std::vector<SurfaceHistory<dim>> histories;
    TiesHistory<dim>                 ties;
    // an archive takes the lengths that it reads for true
    std::string begin(saved_state.size(), ' ');
    in.read(&begin[0], begin.size());
    try
      {
        AssertThrow(begin == saved_state, ExcIO());
        boost::archive::binary_iarchive archive(in);
        archive >> n >> has_ties >> last_report.n_released >>
          last_report.n_augmentations_total >> committed_time >> dissipation;
        AssertThrow(n == sweeps.size() && has_ties == (tie_sweep != nullptr),
                    ExcMessage("The saved state belongs to an interface of "
                               "another kind than '" +
                               name + "'."));
        histories.resize(n);
        for (auto &history : histories)
          archive >> history;
        for (const auto &body : rigid_bodies)
          archive >> *body;
        if (has_ties)
          archive >> ties;
      }
    catch (const ExcMessage &)
      {
        throw;
      }
    catch (const std::exception &)
      {
        AssertThrow(false,
                    ExcMessage("Interface '" + name +
                               "': this is no state that save() wrote, or not "
                               "all of it."));
      }

    // everything where it was accepted
    place_rigid_bodies(committed_time);
    for (auto &surface : surfaces)
      surface.move([&](const auto dof) { return value(dof); });
    bring_candidates_near();
    for (unsigned int i = 0; i < n; ++i)
      sweeps[i]->continue_from(histories[i],
                               parameters.initial_penetration ==
                                 InitialPenetration::track);
    if (tie_sweep)
      {
        tie_sweep->continue_from(
          ties, Utilities::MPI::this_mpi_process(communicator) == 0);
        exclude_tied_facets();
      }
    last_time            = committed_time;
    committed_values     = values;
    accepted_values      = values;
    has_committed_values = true;
    has_accepted_values  = true;
    accepted_report      = last_report;
  }


  template void
  ContactInterface<2>::save(std::ostream &) const;
  template void
  ContactInterface<2>::load_at_fetched(std::istream &);
  template void
  ContactInterface<3>::save(std::ostream &) const;
  template void
  ContactInterface<3>::load_at_fetched(std::istream &);
} // namespace MortarContact
