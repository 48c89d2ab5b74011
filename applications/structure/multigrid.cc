// SPDX-License-Identifier: LGPL-2.1-or-later
#include "multigrid.h"

#include <Epetra_MultiVector.h>
#include <Teuchos_ParameterList.hpp>

#include <algorithm>

namespace Structure
{
  Multigrid::Multigrid(const TrilinosWrappers::SparseMatrix   &A,
                       const std::vector<std::vector<double>> &rigid_body_modes)
    : finest(A)
  {
    for (BlockSmoother::Values *v : {&x, &b, &r})
      v->resize(finest.n_columns());
    rest.reinit(A.locally_owned_range_indices(), A.get_mpi_communicator());
    update();

    // ML leaves the finest level alone: from zero, it restricts what it gets
    TrilinosWrappers::PreconditionAMG::AdditionalData data;
    data.elliptic              = true;
    data.aggregation_threshold = 0.02;
    data.smoother_sweeps       = 2;
    Teuchos::ParameterList              list;
    std::unique_ptr<Epetra_MultiVector> modes;
    data.set_parameters(list, modes, A);
    modes =
      std::make_unique<Epetra_MultiVector>(A.trilinos_matrix().DomainMap(),
                                           rigid_body_modes.size());
    for (unsigned int m = 0; m < rigid_body_modes.size(); ++m)
      std::copy(rigid_body_modes[m].begin(),
                rigid_body_modes[m].end(),
                (*modes)[m]);
    list.set("null space: type", "pre-computed");
    list.set("null space: dimension", modes->NumVectors());
    list.set("null space: vectors", modes->Values());
    list.set("smoother: type (level 0)", "do-nothing");
    below.initialize(A, list);
  }


  void
  Multigrid::update()
  {
    finest.copy_values();
  }


  void
  Multigrid::vmult(TrilinosWrappers::MPI::Vector       &dst,
                   const TrilinosWrappers::MPI::Vector &src) const
  {
    // Single precision has a small range: to be safe, in units of the source.
    const double scale = src.linfty_norm();
    if (scale == 0.)
      {
        dst = 0.;
        return;
      }
    const unsigned int n        = src.locally_owned_size();
    const double      *from     = src.begin();
    double            *to       = dst.begin();
    double            *residual = rest.begin();
    for (unsigned int i = 0; i < n; ++i)
      b[i] = r[i] = from[i] / scale;
    finest.forward_from_zero(x, r);
    std::copy_n(r.begin(), n, residual);
    below.vmult(dst, rest);
    for (unsigned int i = 0; i < n; ++i)
      x[i] += to[i];
    finest.backward(x, b);
    for (unsigned int i = 0; i < n; ++i)
      to[i] = scale * x[i];
  }
} // namespace Structure
