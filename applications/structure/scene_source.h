// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_scene_source_h
#define mortar_contact_structure_scene_source_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace Structure
{
  using namespace dealii;

  /// Where a scene's text comes from, as the command line says.
  struct SceneSource
  {
    std::string              file;
    std::vector<std::string> settings; ///< "Section/Sub section/Entry=value"
    std::string              driver;   ///< Must be the file's 'Driver'.
    /// Of the entries as used, those only that differ from their defaults.
    bool only_changed = false;
  };

  /// What was parsed from @p source, in the form of a parameter file.
  std::string
  used_entries(const ParameterHandler &prm, const SceneSource &source);

  /// Parse the text of @p source into @p prm: the file, then the settings.
  /// @param skip_undefined First pass: leave undeclared entries alone.
  void
  parse(ParameterHandler  &prm,
        const SceneSource &source,
        const bool         skip_undefined);
} // namespace Structure

#endif
