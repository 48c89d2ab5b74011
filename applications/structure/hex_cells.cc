// SPDX-License-Identifier: LGPL-2.1-or-later
#include "hex_cells.h"

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace Structure
{
  namespace
  {
    /**
     * Share k of the bulk modulus K that stays in the matrix where pressures
     * are unknowns. The more of it, the less the iterations suffer from
     * pressures that alternate from cell to cell, of which displacements of
     * trilinear cells know little; the less of it, the better is multigrid.
     * The best k grows slowly with K (benchmarks/results.md). Two mu keep the
     * matrix definite under the deviatoric stresses that occur.
     */
    double
    bulk_in_matrix(const double bulk, const double mu)
    {
      return std::min(bulk, mu * std::max(2., std::cbrt(bulk / mu)));
    }

    /// The number of the pair of nodes (a, b), a <= b.
    unsigned int
    pair_of(const unsigned int a, const unsigned int b)
    {
      return a * (2 * HexKernel::n_nodes - a + 1) / 2 + b - a;
    }
  } // namespace


  bool
  HexCells::fit(const SolidBody<3> &body)
  {
    return body.elements[0].degree == 1 && body.has_hypercubes_only &&
           body.material->is_neo_hookean &&
           body.material->is_split() == body.mean_dilatation;
  }


  HexCells::HexCells(const SolidBody<3> &body,
                     const IndexSet     &owned,
                     const IndexSet     &relevant)
    : body(body)
    , first_owned(owned.n_elements() > 0 ? owned.nth_index_in_set(0) : 0)
    , cells(body.n_local_cells())
    , positions(body.n_local_cells())
  {
    kernel.mu           = body.material->shear_modulus;
    kernel.bulk         = body.material->bulk_modulus;
    kernel.has_pressure = body.mean_dilatation;

    std::vector<types::global_dof_index> dofs;
    for (unsigned int c = 0; c < cells.size(); ++c)
      {
        body.dofs_of(c, dofs);
        cells[c].is_owned = true;
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            Assert(dofs[3 * a + 2] == dofs[3 * a] + 2, ExcInternalError());
            cells[c].dofs[a]    = dofs[3 * a];
            cells[c].ghosted[a] = relevant.index_within_set(dofs[3 * a]);
            cells[c].is_owned =
              cells[c].is_owned && owned.is_element(dofs[3 * a]);
            const Point<3> x = body.vertex_of(c, a);
            for (unsigned int i = 0; i < 3; ++i)
              positions[c][3 * a + i] = x[i];
          }
        const auto &of_cell = cells[c].dofs;
        for (unsigned int a = 0; a < n_nodes; ++a)
          cells[c].order[a] =
            std::count_if(of_cell.begin(), of_cell.end(), [&](const auto dof) {
              return dof < of_cell[a];
            });
      }
  }


  void
  HexCells::resolve(const types::global_dof_index    dof,
                    const AffineConstraints<double> &constraints,
                    Entries                         &entries)
  {
    entries.clear();
    if (!constraints.is_constrained(dof))
      entries.emplace_back(dof, 1.);
    else if (const auto *line = constraints.get_constraint_entries(dof))
      entries.assign(line->begin(), line->end());
  }


  void
  HexCells::add_couplings(const types::global_dof_index    first,
                          const AffineConstraints<double> &constraints,
                          DynamicSparsityPattern          &pattern) const
  {
    Entries                              entries;
    std::vector<types::global_dof_index> columns_of_cell;
    for (unsigned int c = 0; c < n_pressures(); ++c)
      {
        columns_of_cell.clear();
        for (unsigned int a = 0; a < n_nodes; ++a)
          for (unsigned int i = 0; i < 3; ++i)
            {
              resolve(cells[c].dofs[a] + i, constraints, entries);
              for (const auto &entry : entries)
                columns_of_cell.push_back(entry.first);
            }
        pattern.add_entries(first + c,
                            columns_of_cell.begin(),
                            columns_of_cell.end());
      }
  }


  void
  HexCells::set_matrix(const Matrix_t                  &matrix,
                       const AffineConstraints<double> &constraints)
  {
    const Epetra_CrsMatrix &epetra  = matrix.trilinos_matrix();
    int                    *offsets = nullptr, *indices = nullptr;
    const int               error =
      epetra.ExtractCrsDataPointers(offsets, indices, matrix_values);
    AssertThrow(error == 0, ExcTrilinosError(error));
    row_begin = offsets;

    columns.clear();
    columns.resize(cells.size());
    for (unsigned int c = 0; c < cells.size(); ++c)
      {
        Cell &cell    = cells[c];
        cell.is_plain = cell.is_owned;
        for (unsigned int a = 0; a < n_nodes && cell.is_plain; ++a)
          for (unsigned int i = 0; i < 3; ++i)
            cell.is_plain =
              cell.is_plain && !constraints.is_constrained(cell.dofs[a] + i);
        if (!cell.is_plain)
          continue;
        // owned columns come first and in order
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            const unsigned int row = cell.dofs[a] - first_owned;
            for (unsigned int b = 0; b < n_nodes; ++b)
              {
                const int  column = cell.dofs[b] - first_owned;
                const int *begin  = indices + row_begin[row];
                const int *end    = indices + row_begin[row + 1];
                const int *at     = std::lower_bound(begin, end, column);
                columns[c][n_nodes * a + b] = at - begin;
                // the rows of a node have the same columns
                for (unsigned int i = 0; i < 3; ++i)
                  for (unsigned int j = 0; j < 3; ++j)
                    {
                      const int k = row_begin[row + i] + (at - begin) + j;
                      AssertThrow(k < row_begin[row + i + 1] &&
                                    indices[k] == column + static_cast<int>(j),
                                  ExcInternalError());
                    }
              }
          }
      }
  }


  unsigned int
  HexCells::fill(const unsigned int first,
                 const double      *u_values,
                 HexKernel::Cells  &in) const
  {
    const unsigned int n_lanes =
      std::min<unsigned int>(width, cells.size() - first);
    for (unsigned int l = 0; l < width; ++l)
      {
        const unsigned int c = first + std::min(l, n_lanes - 1);
        for (unsigned int a = 0; a < n_nodes; ++a)
          for (unsigned int i = 0; i < 3; ++i)
            {
              in.X[a][i][l] = positions[c][3 * a + i];
              in.u[a][i][l] = u_values[cells[c].ghosted[a] + i];
            }
      }
    return n_lanes;
  }


  double
  HexCells::energy(const Vector_t &u) const
  {
    double            sum = 0.;
    HexKernel::Cells  in;
    HexKernel::Result out;
    for (unsigned int first = 0; first < cells.size(); first += width)
      {
        const unsigned int n_lanes = fill(first, u.begin(), in);
        kernel.evaluate(in, false, false, out);
        for (unsigned int l = 0; l < n_lanes; ++l)
          sum += out.energy[l];
      }
    return sum;
  }


  void
  HexCells::add_constrained(const Cell              &cell,
                            const HexKernel::Result &result,
                            const unsigned int       lane,
                            const double             along_dv,
                            const Target            &target) const
  {
    std::vector<types::global_dof_index> dofs(n_dofs);
    Vector<double>                       forces(n_dofs);
    for (unsigned int a = 0; a < n_nodes; ++a)
      for (unsigned int i = 0; i < 3; ++i)
        {
          dofs[3 * a + i]   = cell.dofs[a] + i;
          forces(3 * a + i) = result.forces[a][i][lane];
        }
    target.internal.add(dofs, forces);
    forces *= -1.;
    if (target.matrix == nullptr)
      {
        target.constraints.distribute_local_to_global(forces, dofs, target.rhs);
        return;
      }
    FullMatrix<double> tangent(n_dofs, n_dofs);
    for (unsigned int a = 0; a < n_nodes; ++a)
      for (unsigned int b = a; b < n_nodes; ++b)
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            {
              const double k =
                result.tangent[pair_of(a, b)][i][j][lane] +
                along_dv * result.dv[a][i][lane] * result.dv[b][j][lane];
              tangent(3 * a + i, 3 * b + j) = k;
              tangent(3 * b + j, 3 * a + i) = k;
            }
    target.constraints.distribute_local_to_global(
      tangent, forces, dofs, *target.matrix, target.rhs);
  }


  void
  HexCells::set_derivative(const Cell                   &cell,
                           const HexKernel::Result      &result,
                           const unsigned int            lane,
                           const types::global_dof_index row,
                           const Target                 &target,
                           PressureUnknowns             &pressures) const
  {
    if (cell.is_plain)
      {
        // owned columns are in order: node after node
        const Epetra_CrsMatrix &B = pressures.derivative.trilinos_matrix();
        int                     n_entries = 0, *indices = nullptr;
        double                 *values = nullptr;
        B.ExtractMyRowView(row - pressures.owned.nth_index_in_set(0),
                           n_entries,
                           values,
                           indices);
        Assert(n_entries == n_dofs, ExcInternalError());
        for (unsigned int a = 0; a < n_nodes; ++a)
          for (unsigned int i = 0; i < 3; ++i)
            values[3 * cell.order[a] + i] = result.dv[a][i][lane];
        return;
      }
    std::map<types::global_dof_index, double> sums;
    Entries                                   entries;
    double                                    prescribed = 0.;
    for (unsigned int a = 0; a < n_nodes; ++a)
      for (unsigned int i = 0; i < 3; ++i)
        {
          const double dv = result.dv[a][i][lane];
          resolve(cell.dofs[a] + i, target.constraints, entries);
          for (const auto &[dof, weight] : entries)
            sums[dof] += weight * dv;
          if (target.constraints.is_constrained(cell.dofs[a] + i))
            prescribed +=
              dv * target.constraints.get_inhomogeneity(cell.dofs[a] + i);
        }
    std::vector<types::global_dof_index> dofs;
    std::vector<double>                  values;
    for (const auto &[dof, value] : sums)
      {
        dofs.push_back(dof);
        values.push_back(value);
      }
    if (!dofs.empty())
      pressures.derivative.set(
        row, dofs.size(), dofs.data(), values.data(), false);
    pressures.prescribed(row) = prescribed;
  }


  std::string
  HexCells::assemble(const Vector_t    &u,
                     const Target      &target,
                     PressureUnknowns  &pressures,
                     const unsigned int first_pressure,
                     const bool         reset)
  {
    const bool   with_tangent = target.matrix != nullptr;
    const bool   unknown      = kernel.has_pressure && pressures.are_on;
    const double share =
      unknown ? bulk_in_matrix(kernel.bulk, kernel.mu) : kernel.bulk;
    const types::global_dof_index first_row =
      unknown && !cells.empty() ?
        pressures.owned.nth_index_in_set(0) + first_pressure :
        0;
    const double     *u_values = u.begin();
    double           *rhs      = target.rhs.begin();
    double           *internal = target.internal.begin();
    HexKernel::Cells  in;
    HexKernel::Result out;
    for (unsigned int first = 0; first < cells.size(); first += width)
      {
        // Step 1: eight cells.
        const unsigned int n_lanes = fill(first, u_values, in);
        for (unsigned int l = 0; l < width; ++l)
          in.pressure[l] =
            unknown ?
              pressures.value
                .begin()[first_pressure + first + std::min(l, n_lanes - 1)] :
              0.;
        kernel.evaluate(in, unknown && !reset, with_tangent, out);
        for (unsigned int l = 0; l < n_lanes; ++l)
          if (!(out.smallest_J[l] > 0.))
            return body.name_of(first + l) + " turned inside out";

        for (unsigned int l = 0; l < n_lanes; ++l)
          {
            const unsigned int c        = first + l;
            const Cell        &cell     = cells[c];
            const double       V        = out.volume[l];
            const double       along_dv = kernel.has_pressure ? share / V : 0.;

            // Step 2: forces and tangent.
            if (cell.is_plain)
              {
                for (unsigned int a = 0; a < n_nodes; ++a)
                  for (unsigned int i = 0; i < 3; ++i)
                    {
                      const unsigned int row = cell.dofs[a] - first_owned + i;
                      rhs[row] -= out.forces[a][i][l];
                      internal[row] += out.forces[a][i][l];
                    }
                if (with_tangent)
                  for (unsigned int a = 0, k = 0; a < n_nodes; ++a)
                    {
                      const unsigned int row_a = cell.dofs[a] - first_owned;
                      for (unsigned int b = a; b < n_nodes; ++b, ++k)
                        {
                          const unsigned int row_b = cell.dofs[b] - first_owned;
                          const unsigned int ab = columns[c][n_nodes * a + b];
                          const unsigned int ba = columns[c][n_nodes * b + a];
                          for (unsigned int i = 0; i < 3; ++i)
                            for (unsigned int j = 0; j < 3; ++j)
                              {
                                const double value =
                                  out.tangent[k][i][j][l] +
                                  along_dv * out.dv[a][i][l] * out.dv[b][j][l];
                                matrix_values[row_begin[row_a + i] + ab + j] +=
                                  value;
                                if (a != b)
                                  matrix_values[row_begin[row_b + j] + ba +
                                                i] += value;
                              }
                        }
                    }
              }
            else
              add_constrained(cell, out, l, along_dv, target);

            // Step 3: what belongs to the pressures.
            if (!unknown)
              continue;
            const unsigned int p = first_pressure + c;
            if (reset)
              pressures.value.begin()[p] = out.pressure[l];
            pressures.residual.begin()[p] =
              out.new_volume[l] - V - V * out.pressure[l] / kernel.bulk;
            if (!with_tangent)
              continue;
            // nearly compressible: all of it is in the matrix
            const double left =
              std::max(kernel.bulk - share, 1e-12 * kernel.bulk);
            pressures.compliance.begin()[p] = V / left;
            pressures.schur.begin()[p]     = V / left + V / (kernel.mu + share);
            pressures.in_matrix.begin()[p] = share / V;
            pressures.scale.begin()[p]     = kernel.mu / std::cbrt(V);
            set_derivative(cell, out, l, first_row + c, target, pressures);
          }
      }
    return "";
  }
} // namespace Structure
