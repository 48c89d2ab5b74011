// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_applications_thicken_h
#define mortar_contact_applications_thicken_h

#include <deal.II/base/tensor.h>

#include <vector>

namespace Structure
{
  using namespace dealii;

  /**
   * Replace a sheet by its closed outer surface: facets at half the thickness
   * on both sides, and across the free edges. Facets of the sheet run alike
   * around its normal.
   * @throw ExcMessage if they do not, or if the sheet is folded onto itself.
   */
  void
  thicken(const double                            thickness,
          std::vector<Tensor<1, 3>>              &vertices,
          std::vector<std::vector<unsigned int>> &facets);
} // namespace Structure

#endif
