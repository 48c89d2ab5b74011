// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_stop_signal_h
#define mortar_contact_structure_stop_signal_h

#include <deal.II/base/mpi.h>

namespace Structure
{
  /// From now on SIGTERM and SIGUSR1 ask for a stop after the step under way
  /// (or the trial of one); a second one ends the program.
  /// (mpirun ends all ranks at SIGTERM but hands SIGUSR1 on to them.)
  void
  catch_stop_signals();

  /// Whether any rank was asked to stop. Collective.
  bool
  stop_is_requested(const MPI_Comm communicator);
} // namespace Structure

#endif
