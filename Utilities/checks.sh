#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The tests that read the sources alone: rooms, names, methods, guide. No build, no more than python3.
cd "$(dirname "$0")/.." || exit 2
status=0
for check in \
  "Testing/Rooms/check_rooms.py Filters/Core" \
  "Testing/Documentation/check_names.py ." \
  "Testing/Documentation/check_methods.py ." \
  "Utilities/guide.py --check" \
  "Testing/Guide/check_guide.py ."
do
  # shellcheck disable=SC2086
  python3 -B $check || { echo "$check: not in order" >&2; status=1; }
done
exit $status
