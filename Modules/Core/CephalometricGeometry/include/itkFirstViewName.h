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
#ifndef itkFirstViewName_h
#define itkFirstViewName_h

namespace itk
{
/** What the radiograph that a case is about is called beside its further views: in scenes, results and options. No
 * further view may be called so.
 * \ingroup CephalometricGeometry */
inline constexpr char FirstViewName[] = "lateral";
} // namespace itk

#endif
