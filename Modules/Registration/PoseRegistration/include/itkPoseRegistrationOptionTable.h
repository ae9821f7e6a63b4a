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
#ifndef itkPoseRegistrationOptionTable_h
#define itkPoseRegistrationOptionTable_h

#include "PoseRegistrationExport.h"
#include "itkPoseRegistrationTypes.h"

#include <string>
#include <variant>
#include <vector>

namespace itk
{
/** \class PoseRegistrationOptionTable
 * \brief The fields of PoseRegistrationOptions by name and text, for command lines and scripts. Free of ITK headers.
 *
 * What a case says itself (traced side, manual control), threads and callbacks are not in it. Switches take on, off,
 * true, false, 1, 0; lists take numbers with commas.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT PoseRegistrationOptionTable
{
public:
  /** The member of the struct that an option is: a switch, a number of things, a number or some numbers. */
  using FieldType = std::variant<bool                PoseRegistrationOptions::*,
                                 unsigned int        PoseRegistrationOptions::*,
                                 double              PoseRegistrationOptions::*,
                                 std::vector<double> PoseRegistrationOptions::*>;

  /** An option and its words. */
  struct EntryType
  {
    std::string name; /**< As the options of the program and of Python name it. */
    /** In a few words, with the unit. */
    std::string description;
    /** For those who make properties of another language from the table. */
    FieldType field;
  };

  /** In the order of the struct. */
  static std::vector<EntryType>
  GetEntries();

  /** Throws std::invalid_argument that names the unknown option and lists what there is. */
  static std::string
  Get(const PoseRegistrationOptions & options, const std::string & name);

  /** Throws std::invalid_argument for an unknown name, or a value that is none or out of range. */
  static void
  Set(PoseRegistrationOptions & options, const std::string & name, const std::string & value);

  /** A switch's value, for options that are kept elsewhere. Throws std::invalid_argument that names the option. */
  static bool
  ParseSwitch(const std::string & name, const std::string & value);

  /** "NAME=VALUE". */
  static void
  Set(PoseRegistrationOptions & options, const std::string & assignment);

  /** What differs from the defaults, as assignments. */
  static std::vector<std::string>
  GetChanges(const PoseRegistrationOptions & options);
};
} // namespace itk

#endif
