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
#ifndef itkVectorClones_h
#define itkVectorClones_h

/** Before a function whose loops vectorise: it is compiled a second time for x86-64-v3 (AVX2), and the machine decides
 * at load time which is called. Without contraction of multiply-adds, which the project forbids, both give the same
 * bits. Elsewhere nothing. Only where it buys 1.3 times or more; not under sanitizers, which come too late for the choice.
 * \ingroup DentalCommon */
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) &&                            \
  !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#  define itkVectorClones __attribute__((target_clones("default", "arch=x86-64-v3")))
#else
#  define itkVectorClones
#endif

#endif
