// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_host_dof_numbering_h
#define mortar_contact_host_dof_numbering_h

#include <deal.II/base/exceptions.h>
#include <deal.II/base/types.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace MortarContact
{
  using namespace dealii;

  /**
   * Numbers that the dofs of a DoFHandler have in the host's matrix. Hosts with
   * one DoFHandler leave it alone; hosts that put several DoFHandlers into one
   * matrix give an offset or, if each rank is to own one contiguous range of
   * the matrix, one shift per range of dofs.
   */
  class DoFNumbering
  {
  public:
    /// The same numbers, plus @p offset.
    DoFNumbering(const types::global_dof_index offset = 0)
      : firsts(1, 0)
      , targets(1, offset)
    {}

    /// Dofs from firsts[r] on, up to the next, go to targets[r] and following.
    /// @p firsts ascends from 0.
    DoFNumbering(std::vector<types::global_dof_index> firsts,
                 std::vector<types::global_dof_index> targets)
      : firsts(std::move(firsts))
      , targets(std::move(targets))
    {
      AssertDimension(this->firsts.size(), this->targets.size());
    }

    /// The number in the system of what the DoFHandler calls @p dof.
    types::global_dof_index
    operator()(const types::global_dof_index dof) const
    {
      const std::size_t r =
        std::upper_bound(firsts.begin(), firsts.end(), dof) - firsts.begin() -
        1;
      return targets[r] + (dof - firsts[r]);
    }

  private:
    std::vector<types::global_dof_index> firsts, targets;
  };
} // namespace MortarContact

#endif
