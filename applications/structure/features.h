// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_features_h
#define mortar_contact_structure_features_h

#include "scene.h"

#include <string>
#include <vector>

namespace Structure
{
  /// A part of the program that a scene may need.
  struct Feature
  {
    std::string              name;
    std::vector<std::string> because; ///< Entries that ask for it; empty: off.
  };

  /// All features that cost something where they are on.
  std::vector<Feature>
  features(const Scene &scene);

  /// What is on, and why, a line each; then what is off.
  std::string
  text_of(const std::vector<Feature> &features);
} // namespace Structure

#endif
