// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fuzz.h"

#include <structure/scene.h>

// The first byte chooses the format.
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size)
{
  if (size == 0)
    return 0;
  Structure::SceneSource source;
  source.driver = "contact_scene";
  source.file   = Fuzz::file_of(data + 1,
                              size - 1,
                              data[0] == '{' ? "fuzz.json" : "fuzz.prm");
  Fuzz::read_or_refuse([&]() {
    std::string used;
    (void)Structure::read_scene(source, used);
  });
  return 0;
}
