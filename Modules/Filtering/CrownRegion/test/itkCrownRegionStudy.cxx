/*=========================================================================
 *
 *  Copyright The DentalSCR authors
 *
 *  Licensed under the Apache License, Version 2.0 (the "License");
 *  you may not use this file except in compliance with the License.
 *  You may obtain a copy of the License at
 *
 *         https://www.apache.org/licenses/LICENSE-2.0
 *
 *  Unless required by applicable law or agreed to in writing, software
 *  distributed under the License is distributed on an "AS IS" BASIS,
 *  WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
 *  See the License for the specific language governing permissions and
 *  limitations under the License.
 *
 *=========================================================================*/
#include "itkCrownRegionTestSupport.h"

#include <algorithm>
#include <iostream>
#include <string>

// Makes the table of Documentation/CrownRegion.md: CrownRegionStudy KIND FIRST_SEED COUNT.
int
main(int argc, char * argv[])
{
  using CrownRegionTest::Kind;
  const std::pair<const char *, Kind> kinds[] = { { "regular", Kind::Regular },
                                                  { "stone", Kind::Stone },
                                                  { "irregular", Kind::Irregular },
                                                  { "wide", Kind::Wide },
                                                  { "wide-square", Kind::WideSquare } };
  const auto                          kind = std::find_if(
    std::begin(kinds), std::end(kinds), [&](const auto & k) { return argc == 4 && argv[1] == std::string(k.first); });
  if (kind == std::end(kinds))
  {
    std::cerr << "usage: CrownRegionStudy regular|stone|irregular|wide|wide-square FIRST_SEED COUNT" << std::endl;
    return 2;
  }
  const std::uint64_t first = std::stoull(argv[2]);
  const std::uint64_t count = std::stoull(argv[3]);
  double              sum[2] = { 0.0, 0.0 };
  double              worst[2] = { 1.0, 1.0 };
  unsigned int        below[2] = { 0, 0 };
  for (std::uint64_t seed = first; seed < first + count; ++seed)
  {
    const auto phantom = CrownRegionTest::MakeCase(seed, kind->second, 15000);
    for (unsigned int jaw = 0; jaw < 2; ++jaw)
    {
      const double value = CrownRegionTest::IoU(phantom, jaw, CrownRegionTest::Find(phantom, jaw));
      std::cout << kind->first << ' ' << seed << (jaw == 0 ? " upper " : " lower ") << value << std::endl;
      sum[jaw] += value / static_cast<double>(count);
      worst[jaw] = std::min(worst[jaw], value);
      below[jaw] += value < 0.85 ? 1 : 0;
    }
  }
  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    std::cout << (jaw == 0 ? "upper" : "lower") << ": mean " << sum[jaw] << ", worst " << worst[jaw]
              << ", below 0.85: " << below[jaw] << " of " << count << std::endl;
  }
  return 0;
}
