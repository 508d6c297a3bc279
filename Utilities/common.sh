# SPDX-License-Identifier: BSD-3-Clause
#
# What demo.sh and test.sh have in common: sourced, not run. Leaves $source_dir and $build_dir set.

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=${HEXSWEEP_BUILD_DIR:-$source_dir/build/release}

say() { printf '== %s\n' "$*"; }

# One compile job a processor, but no more than the memory carries: a file of ours that
# instantiates Eigen, or a wrapper of VTK, takes up to 1.5 GB of compiler.
job_count() {
  local processors gigabytes jobs
  processors=$(nproc)
  gigabytes=$(awk '/^MemAvailable:/ { print int($2 / 1024 / 1024) }' /proc/meminfo)
  jobs=$((gigabytes * 2 / 3))
  ((jobs < 1)) && jobs=1
  ((jobs > processors)) && jobs=$processors
  echo "$jobs"
}

# configure_and_build TARGET...: from the release preset, into $build_dir. HEXSWEEP_CMAKE_OPTIONS are
# options of CMake beside it, e.g. -DHEXSWEEP_WERROR=ON.
configure_and_build() {
  local jobs
  jobs=$(job_count)
  say "configure: $build_dir"
  # ParaView's Python modules belong to the system's interpreter, whatever else is on PATH.
  # shellcheck disable=SC2086 # several words
  (cd "$source_dir" &&
    cmake --preset release -B "$build_dir" -DPython3_EXECUTABLE=/usr/bin/python3 ${HEXSWEEP_CMAKE_OPTIONS:-})
  say "build: $* with $jobs job(s)"
  cmake --build "$build_dir" --target "$@" -j "$jobs"
}

# One X server without a screen for the whole run, drawing in software; gone when the script ends.
start_display() {
  local number_file
  number_file=$(mktemp)
  # Xvfb takes the first free display number itself and writes it to file descriptor 3. Without
  # -noreset it starts anew whenever its last client leaves, and turns away who comes just then.
  Xvfb -displayfd 3 -screen 0 1920x1200x24 -nolisten tcp -noreset \
    3>"$number_file" >/dev/null 2>&1 &
  display_pid=$!
  trap 'kill "$display_pid" 2>/dev/null || true' EXIT
  local tries=0
  until [[ -s $number_file ]]; do
    if ! kill -0 "$display_pid" 2>/dev/null || ((++tries > 300)); then
      echo "Xvfb did not start" >&2
      return 1
    fi
    sleep 0.1
  done
  DISPLAY=:$(<"$number_file")
  rm -f "$number_file"
  export DISPLAY LIBGL_ALWAYS_SOFTWARE=1
  say "display: Xvfb $DISPLAY (software rendering)"
}
