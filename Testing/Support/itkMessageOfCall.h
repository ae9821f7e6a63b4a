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
#ifndef itkMessageOfCall_h
#define itkMessageOfCall_h

#include "itkMacro.h"

#include <string>

namespace itk
{
/** The description of the exception that a call throws; "" where it throws none. */
template <typename TCall>
std::string
MessageOfCall(TCall && call)
{
  try
  {
    call();
  }
  catch (const ExceptionObject & error)
  {
    return error.GetDescription();
  }
  return "";
}
} // namespace itk

#endif
