// SPDX-License-Identifier: LGPL-2.1-or-later
#include "multigrid.h"

#include "return_memory.h"

#include <Epetra_MultiVector.h>
#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>

#include <algorithm>

namespace Structure
{
  Multigrid::Multigrid(const TrilinosWrappers::SparseMatrix   &A,
                       const std::vector<std::vector<double>> &rigid_body_modes)
  {
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
    // The product of the matrix with a smooth prolongation would be the peak of
    // the memory, in three times the time, for a fifth fewer iterations
    // (benchmarks/results.md).
    list.sublist("aggregation: list (level 0)")
      .set("aggregation: smoothing sweeps", 0);
    below.initialize(A, list);
    return_memory();
    update(A); // what ML needed for a while is free again
    // GetML() is const, but cycles take what is not
    ml = const_cast<ML *>(
      dynamic_cast<const ML_Epetra::MultiLevelPreconditioner &>(
        below.trilinos_operator())
        .GetML());
    rest.resize(A.local_size());
    if (has_levels())
      {
        const unsigned int n = ml->Rmat[ml->ML_finest_level].outvec_leng;
        coarse_rest.resize(n);
        coarse.resize(n);
      }
  }


  bool
  Multigrid::has_levels() const
  {
    return ml->ML_num_actual_levels > 1;
  }


  void
  Multigrid::update(const TrilinosWrappers::SparseMatrix &matrix)
  {
    if (!finest)
      {
        finest = std::make_unique<BlockSmoother>(matrix);
        for (BlockSmoother::Values *v : {&x, &b, &r})
          v->resize(finest->n_columns());
      }
    finest->copy_values();
  }


  void
  Multigrid::correct() const
  {
    ML_1Level *level = &ml->SingleLevel[ml->ML_finest_level];
    const auto cycle = [this](ML_1Level           *from,
                              std::vector<double> &residual,
                              std::vector<double> &correction) {
      ML_Cycle_MG(from,
                  correction.data(),
                  residual.data(),
                  ML_ZERO,
                  ml->comm,
                  ML_NO_RES_NORM,
                  ml);
    };
    if (!has_levels())
      {
        coarse_rest = rest;
        cycle(level, coarse_rest, rest);
        return;
      }
    ML_1Level *next = level->Rmat->to;
    ML_Operator_Apply(level->Rmat,
                      rest.size(),
                      rest.data(),
                      coarse_rest.size(),
                      coarse_rest.data());
    cycle(next, coarse_rest, coarse);
    ML_Operator_Apply(
      next->Pmat, coarse.size(), coarse.data(), rest.size(), rest.data());
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
    const unsigned int n    = src.locally_owned_size();
    const double      *from = src.begin();
    double            *to   = dst.begin();
    for (unsigned int i = 0; i < n; ++i)
      b[i] = r[i] = from[i] / scale;
    finest->forward_from_zero(x, r);
    std::copy_n(r.begin(), n, rest.begin());
    correct();
    for (unsigned int i = 0; i < n; ++i)
      x[i] += rest[i];
    finest->backward(x, b);
    for (unsigned int i = 0; i < n; ++i)
      to[i] = scale * x[i];
  }
} // namespace Structure
