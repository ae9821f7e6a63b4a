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
#ifndef itkBatchCase_h
#define itkBatchCase_h

#include <string>
#include <utility>
#include <vector>

namespace itk
{
/** \struct BatchCase
 * \brief One of many cases: a case file, or the options of `dentalscr register` that take its place.
 * \ingroup Batch
 */
struct BatchCase
{
  /** Its name in tables, and that of its folder of results: unlike all others of the batch. */
  std::string id;
  /** The case file, or options. */
  std::vector<std::string> arguments;
  /** What a table says of it besides, by column: it is handed through. */
  std::vector<std::pair<std::string, std::string>> columns;
};
} // namespace itk

#endif
