// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_host_contact_interface_templates_h
#define mortar_contact_host_contact_interface_templates_h

// The thin part of ContactInterface that depends on the host's vectors and
// matrices. Included by contact_interface.h.

#include <mortar_contact/host/contact_interface.h>
#include <mortar_contact/host/local_rows.h>

#include <type_traits>

namespace MortarContact
{
  template <int dim>
  template <class VectorType>
  void
  ContactInterface<dim>::fetch(const VectorType &u)
  {
    AssertThrow(is_set_up,
                ExcMessage("Interface '" + name +
                           "': call setup() after the surfaces are added."));
    AssertThrow(end_of_dofs <= u.size(),
                ExcMessage("Interface '" + name + "': the vector has " +
                           std::to_string(u.size()) +
                           " entries, the surfaces have dof " +
                           std::to_string(end_of_dofs - 1) +
                           "; after dofs are numbered anew, add the surfaces "
                           "again."));
    prepare_fetch(u.locally_owned_elements());
    std::map<unsigned int, std::vector<double>> answers;
    for (const auto &[rank, asked] : asked_of_me)
      {
        std::vector<double> &of_rank = answers[rank];
        of_rank.reserve(asked.size());
        for (const auto dof : asked)
          of_rank.push_back(u(dof));
      }
    exchange(answers);
  }


  template <int dim>
  template <class VectorType>
  void
  ContactInterface<dim>::update(const VectorType &u,
                                const double      time,
                                const bool        with_tangent)
  {
    fetch(u);
    // surfaces that are nowhere stay where they were: see advice()
    if (is_finite)
      {
        if (time == committed_time)
          {
            committed_values     = values;
            has_committed_values = true;
          }
        else if (time != last_time)
          check_motion_of_tools(time);
        place_rigid_bodies(time);
        for (auto &surface : surfaces)
          surface.move([&](const auto dof) { return value(dof); });
      }
    last_time = time;
    evaluate(time, with_tangent);
    has_tangent = with_tangent;
  }


  template <int dim>
  template <class SparsityType>
  void
  ContactInterface<dim>::add_couplings(
    SparsityType                    &sparsity,
    const AffineConstraints<double> &constraints,
    const double                     motion)
  {
    if (motion > coupled_motion)
      {
        // pairs from farther away: they must be known
        coupled_motion = motion;
        bring_candidates_near();
        for (auto &sweep : sweeps)
          sweep->search();
      }
    coupled.resize(sweeps.size());
    for (unsigned int i = 0; i < sweeps.size(); ++i)
      {
        coupled[i] = sweeps[i]->candidates_after(motion);
        for (const auto &[s, p] : coupled[i])
          constraints.add_entries_local_to_global(dofs_of(i, s, p),
                                                  sparsity,
                                                  false);
      }
    if (tie_sweep)
      for (const auto &[s, p] : tie_sweep->candidates())
        constraints.add_entries_local_to_global(dofs_of(0, s, p),
                                                sparsity,
                                                false);
    pattern_is_current            = true;
    last_report.couplings_changed = false;
  }


  template <int dim>
  template <class MatrixType, class VectorType>
  void
  ContactInterface<dim>::assemble(
    MatrixType                      &matrix,
    VectorType                      &rhs,
    const AffineConstraints<double> &constraints) const
  {
    AssertThrow(pattern_is_current,
                ExcMessage("Interface '" + name +
                           "': pairs have come since the last "
                           "add_couplings(), see report().couplings_changed."));
    AssertThrow(has_tangent,
                ExcMessage("Interface '" + name +
                           "': the last update() was without tangent."));
    std::vector<types::global_dof_index> pair_dofs;
    Vector<double>                       forces;
    FullMatrix<double>                   tangent;
    const auto                           add_pairs = [&](const auto &add) {
      for_each_pair([&](const unsigned int i, const auto &pair) {
        distribute_pair(i, pair, true, pair_dofs, forces, tangent);
        if (add())
          rhs.add(pair_dofs, forces);
        else
          constraints.distribute_local_to_global(
            tangent, forces, pair_dofs, matrix, rhs);
      });
    };
    if constexpr (std::is_same_v<MatrixType, TrilinosWrappers::SparseMatrix>)
      {
        LocalRows rows(matrix, dofs, constraints);
        add_pairs([&]() { return rows.add(tangent, pair_dofs); });
      }
    else
      add_pairs([]() { return false; });
  }


  template <int dim>
  template <class VectorType>
  void
  ContactInterface<dim>::assemble(
    VectorType                      &rhs,
    const AffineConstraints<double> &constraints) const
  {
    std::vector<types::global_dof_index> pair_dofs;
    Vector<double>                       forces;
    FullMatrix<double>                   tangent;
    for_each_pair([&](const unsigned int i, const auto &pair) {
      distribute_pair(i, pair, false, pair_dofs, forces, tangent);
      constraints.distribute_local_to_global(forces, pair_dofs, rhs);
    });
  }


  template <int dim>
  template <class VectorType>
  double
  ContactInterface<dim>::largest_safe_step(const VectorType &u,
                                           const VectorType &du)
  {
    fetch(u);
    std::vector<double> from = values;
    fetch(du);
    std::vector<double> to = from;
    for (std::size_t i = 0; i < values.size(); ++i)
      to[i] += values[i];
    return safe_step_between(from, last_time, to, last_time);
  }


  template <int dim>
  template <class VectorType>
  double
  ContactInterface<dim>::largest_safe_step(const VectorType &u,
                                           const VectorType &du,
                                           const double      time)
  {
    fetch(u);
    std::vector<double> from = values;
    fetch(du);
    std::vector<double> to = from;
    for (std::size_t i = 0; i < values.size(); ++i)
      to[i] += values[i];
    return safe_step_between(from, committed_time, to, time);
  }


  template <int dim>
  template <class VectorType>
  void
  ContactInterface<dim>::load(std::istream &in, const VectorType &u)
  {
    fetch(u);
    load_at_fetched(in);
  }


  template <int dim>
  template <class VectorType>
  double
  ContactInterface<dim>::check_tangent(const VectorType  &u,
                                       const double       time,
                                       const unsigned int n_samples)
  {
    fetch(u);
    return check_tangent_at_fetched(time, n_samples);
  }
} // namespace MortarContact

#endif
