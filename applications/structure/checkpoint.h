// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_checkpoint_h
#define mortar_contact_structure_checkpoint_h

#include <deal.II/base/mpi.h>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <string>
#include <vector>

namespace Structure
{
  /**
   * The complete state of a run at the end of a step: one file, free of the
   * number of ranks. Values of dofs come body by body in Body::dofs_in_order(),
   * then those of rigid bodies.
   */
  struct Checkpoint
  {
    std::string  parameters; ///< That the run used.
    double       time = 0., next_step = 0.;
    unsigned int step = 0, cut_backs = 0, newton_iterations = 0,
                 linear_iterations = 0;
    /// What was done to the meshes: [refinement][body], see Body::refine().
    std::vector<std::vector<std::string>> refinements;
    /// Displacements, then what else the run keeps.
    std::vector<std::vector<double>> vectors;
    /// By body, see Body::history().
    std::vector<std::vector<double>> histories;
    /// See ValveFluid::history(); empty: none.
    std::vector<double> fluid;
    /// By interface, see ContactInterface::save().
    std::vector<std::string> interfaces;
    std::vector<char>        has_touched; ///< By interface.
    /// Start, work, largest, growth and error of the audit of the energy.
    std::vector<double> energies;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &parameters &time &next_step &step &cut_backs &newton_iterations
        &linear_iterations &refinements &vectors &histories &fluid &interfaces
          &has_touched &energies;
    }
  };

  /**
   * Write @p text of rank 0 to the folder "checkpoint" in @p directory, under a
   * @p title of what it is. It replaces the one there when it is complete, not
   * before.
   *
   * @throw ExcMessage on all ranks if it cannot be written.
   */
  void
  write_state(const std::string &title,
              const std::string &text,
              const std::string &directory,
              const MPI_Comm     communicator);

  /**
   * The text that write_state() wrote; on all ranks.
   *
   * @throw ExcMessage on all ranks if there is none, it has another title, or
   * it is damaged.
   */
  std::string
  read_state(const std::string &title,
             const std::string &directory,
             const MPI_Comm     communicator);

  /// write_state() of a checkpoint.
  void
  write_checkpoint(const Checkpoint  &checkpoint,
                   const std::string &directory,
                   const MPI_Comm     communicator);

  /**
   * Read what write_checkpoint() wrote; on all ranks.
   *
   * @throw ExcMessage on all ranks if there is none, it was written by another
   * version, or it is damaged.
   */
  Checkpoint
  read_checkpoint(const std::string &directory, const MPI_Comm communicator);
} // namespace Structure

#endif
