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
#ifndef itkJawIndex_h
#define itkJawIndex_h

#include "itkToothCode.h"

namespace itk
{
/** Place of a jaw in what holds one thing a jaw: the upper one first. */
inline unsigned int
ToIndex(ToothCode::JawEnum jaw)
{
  return jaw == ToothCode::JawEnum::Upper ? 0 : 1;
}
} // namespace itk

#endif
