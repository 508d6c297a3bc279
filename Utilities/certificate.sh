#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Utilities/certificate.sh [hexahedra] [first]
#
# Holds the certificate against exact numbers on so many hexahedra that are hard to judge (ten million), from number
# `first` (0) on; build/release must have been built. 20 s of a processor for a hundred thousand.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
HEXSWEEP_CERTIFICATE_HEXES=${1:-10000000} HEXSWEEP_CERTIFICATE_FIRST=${2:-0} \
  exec build/release/bin/HexSweepCoreTests --gtest_filter='HexCertificateExact.NeverContradictsExactNumbers'
