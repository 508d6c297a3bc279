#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Starts an X server without a screen, runs commands on it, stops it.
#   Display.sh start|stop <folder>
#   Display.sh run <folder> <command> [<argument>...]
set -eu
action=$1
folder=$2
shift 2

stop() {
  if [ -f "$folder/pid" ]; then
    kill "$(cat "$folder/pid")" 2>/dev/null || true
  fi
  rm -f "$folder/pid" "$folder/number"
}

case $action in
  start)
    mkdir -p "$folder"
    stop
    # The server picks a free display number and writes it once it accepts clients. It must not
    # keep the standard streams: the test driver waits until they are closed. It must not start anew
    # whenever its last client leaves: the next one may come just then, and be turned away.
    setsid Xvfb -displayfd 3 -screen 0 1600x1200x24 -nolisten tcp -noreset \
      3>"$folder/number" >/dev/null 2>&1 </dev/null &
    echo $! >"$folder/pid"
    tries=0
    while [ ! -s "$folder/number" ]; do
      tries=$((tries + 1))
      if [ $tries -gt 100 ]; then
        echo "Xvfb did not start" >&2
        exit 1
      fi
      sleep 0.2
    done
    ;;
  stop)
    stop
    ;;
  run)
    DISPLAY=:$(cat "$folder/number")
    export DISPLAY
    # Mesa's software renderer: the same pixels on every machine.
    export LIBGL_ALWAYS_SOFTWARE=1
    exec "$@"
    ;;
  *)
    echo "unknown action $action" >&2
    exit 2
    ;;
esac
