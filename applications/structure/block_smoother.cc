// SPDX-License-Identifier: LGPL-2.1-or-later
#include "block_smoother.h"

#include <deal.II/base/tensor.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_Import.h>
#include <Epetra_Map.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

namespace Structure
{
  BlockSmoother::BlockSmoother(const TrilinosWrappers::SparseMatrix &matrix)
    : original(matrix.trilinos_matrix())
  {
    const unsigned int n_own = original.NumMyRows();
    n_block_rows             = (n_own + size - 1) / size;

    // Step 1: columns. Those of other ranks come after the own ones.
    const Epetra_Map                 &map = original.ColMap();
    std::map<long long, unsigned int> ghost_blocks;
    n_block_columns = n_block_rows;
    position.resize(map.NumMyElements());
    for (unsigned int c = 0; c < position.size(); ++c)
      if (c < n_own)
        position[c] = c;
      else
        {
          const long long gid = map.GID64(c);
          const auto [block, is_new] =
            ghost_blocks.emplace(gid / size, n_block_columns);
          if (is_new)
            ++n_block_columns;
          position[c] = size * block->second + gid % size;
        }
    if (original.Importer() != nullptr)
      {
        owned   = std::make_unique<Epetra_Vector>(original.DomainMap());
        ghosted = std::make_unique<Epetra_Vector>(map);
      }

    // Step 2: blocks.
    std::vector<unsigned int> of_row;
    row_begin.assign(1, 0);
    for (unsigned int r = 0; r < n_block_rows; ++r)
      {
        of_row.clear();
        for (unsigned int row = size * r; row < std::min(n_own, size * (r + 1));
             ++row)
          {
            int     n_entries = 0, *indices = nullptr;
            double *values = nullptr;
            original.ExtractMyRowView(row, n_entries, values, indices);
            for (int k = 0; k < n_entries; ++k)
              of_row.push_back(position[indices[k]] / size);
          }
        of_row.push_back(r);
        std::sort(of_row.begin(), of_row.end());
        of_row.erase(std::unique(of_row.begin(), of_row.end()), of_row.end());
        diagonal.push_back(
          columns.size() +
          (std::lower_bound(of_row.begin(), of_row.end(), r) - of_row.begin()));
        columns.insert(columns.end(), of_row.begin(), of_row.end());
        row_begin.push_back(columns.size());
      }
    blocks.resize(columns.size() + 1);
    inverse_diagonal.resize(n_block_rows + 1);
  }


  void
  BlockSmoother::copy_values()
  {
    const unsigned int       n_own = original.NumMyRows();
    std::vector<std::size_t> place(n_block_columns);
    for (unsigned int r = 0; r < n_block_rows; ++r)
      {
        for (std::size_t b = row_begin[r]; b < row_begin[r + 1]; ++b)
          {
            place[columns[b]] = b;
            blocks[b].fill(0.f);
          }
        for (unsigned int i = 0; i < size && size * r + i < n_own; ++i)
          {
            int     n_entries = 0, *indices = nullptr;
            double *values = nullptr;
            original.ExtractMyRowView(size * r + i, n_entries, values, indices);
            for (int k = 0; k < n_entries; ++k)
              {
                const unsigned int at = position[indices[k]];
                blocks[place[at / size]][size * (at % size) + i] = values[k];
              }
          }

        // The diagonal, with what couples to other ranks.
        Tensor<2, 3> D;
        for (unsigned int i = 0; i < size; ++i)
          {
            for (unsigned int j = 0; j < size; ++j)
              D[i][j] = blocks[diagonal[r]][size * j + i];
            for (std::size_t b = row_begin[r + 1];
                 b-- > row_begin[r] && columns[b] >= n_block_rows;)
              for (unsigned int j = 0; j < size; ++j)
                D[i][i] += 0.5 * std::abs(blocks[b][size * j + i]);
            // what fills up the last block, and unknowns without stiffness
            if (D[i][i] == 0.)
              D[i][i] = 1.;
          }
        const double scale       = std::abs(D[0][0] * D[1][1] * D[2][2]);
        const bool   is_definite = D[0][0] > 0. &&
                                 D[0][0] * D[1][1] > D[0][1] * D[1][0] &&
                                 determinant(D) > 1e-6 * scale;
        // one that is not would turn the correction around
        Tensor<2, 3> inverse;
        if (is_definite)
          inverse = invert(D);
        else
          for (unsigned int i = 0; i < size; ++i)
            inverse[i][i] = 1. / std::abs(D[i][i]);
        for (unsigned int i = 0; i < size; ++i)
          for (unsigned int j = 0; j < size; ++j)
            inverse_diagonal[r][size * j + i] = inverse[i][j];
      }
  }


  void
  BlockSmoother::exchange(Values &x) const
  {
    if (!ghosted)
      return;
    const unsigned int n_own = original.NumMyRows();
    for (unsigned int i = 0; i < n_own; ++i)
      (*owned)[i] = x[i];
    ghosted->Import(*owned, *original.Importer(), Insert);
    for (unsigned int c = n_own; c < position.size(); ++c)
      x[position[c]] = (*ghosted)[c];
  }


  inline BlockSmoother::Four
  BlockSmoother::column(const Block &block, const unsigned int j)
  {
    // the fourth value of the last column is the next block's first
    Four result;
    std::memcpy(&result, block.data() + size * j, sizeof(result));
    return result;
  }


  inline BlockSmoother::Four
  BlockSmoother::product(const Block &block, const float *x)
  {
    return column(block, 0) * x[0] + column(block, 1) * x[1] +
           column(block, 2) * x[2];
  }


  inline BlockSmoother::Four
  BlockSmoother::subtract(const Block        *block,
                          const unsigned int *column,
                          const unsigned int *end,
                          const Values       &x,
                          Four                s)
  {
    for (; column != end; ++column, ++block)
      s -= product(*block, x.data() + size * *column);
    return s;
  }


  void
  BlockSmoother::forward_from_zero(Values &x, Values &r) const
  {
    // The values that come later are zero.
    for (unsigned int row = 0; row < n_block_rows; ++row)
      {
        float      *from       = &r[size * row];
        const Four  s          = subtract(&blocks[row_begin[row]],
                                &columns[row_begin[row]],
                                &columns[diagonal[row]],
                                x,
                                Four{from[0], from[1], from[2]});
        const float rest[size] = {s[0], s[1], s[2]};
        const Four  dx         = product(inverse_diagonal[row], rest);
        for (unsigned int i = 0; i < size; ++i)
          {
            from[i]           = rest[i];
            x[size * row + i] = dx[i];
          }
      }
    exchange(x);
    // What came before is subtracted already.
    for (unsigned int row = 0; row < n_block_rows; ++row)
      {
        float     *from = &r[size * row];
        const Four s    = subtract(&blocks[diagonal[row]],
                                &columns[diagonal[row]],
                                columns.data() + row_begin[row + 1],
                                x,
                                Four{from[0], from[1], from[2]});
        for (unsigned int i = 0; i < size; ++i)
          from[i] = s[i];
      }
  }


  void
  BlockSmoother::backward(Values &x, const Values &b) const
  {
    exchange(x);
    for (unsigned int row = n_block_rows; row-- > 0;)
      {
        // Also backwards within the row: the processor foresees a stream in one
        // direction, and waits three times as long for one that jumps.
        const float *from = &b[size * row];
        Four         s    = {from[0], from[1], from[2]};
        for (std::size_t k = row_begin[row + 1]; k-- > row_begin[row];)
          s -= product(blocks[k], x.data() + size * columns[k]);
        const float rest[size] = {s[0], s[1], s[2]};
        const Four  dx         = product(inverse_diagonal[row], rest);
        for (unsigned int i = 0; i < size; ++i)
          x[size * row + i] += dx[i];
      }
  }
} // namespace Structure
