#!/usr/bin/env bash
# A study by Slurm comes to the same numbers as one by processes of this machine. Sets up a cluster of this one machine
# in a temporary folder (munged, slurmctld, slurmd), without touching one that is installed; leaves nothing running.
# Usage: slurm_test.sh TALUS_CLI PROJECT        Skipped (77) where Slurm is missing or this is not root.
set -euo pipefail
cli=$1 project=$2

export PATH=$PATH:/usr/sbin
for program in munged mungekey slurmctld slurmd sbatch squeue; do
  command -v $program >/dev/null || { echo "skipped: there is no $program"; exit 77; }
done
[[ $EUID -eq 0 ]] || { echo "skipped: slurmd and munged want root"; exit 77; }

# munged wants folders that nobody else may write to above its socket.
folder=$(mktemp -d /run/talus-slurm-XXXXXX)
daemons=()
end_all() {
  for daemon in "${daemons[@]}"; do kill "$daemon" 2>/dev/null || true; done
  wait || true
  rm -rf "$folder"
}
trap end_all EXIT
chmod 755 "$folder"
mkdir -m 755 "$folder"/{state,spool}

mungekey --create --keyfile="$folder/munge.key"
munged --foreground --force --key-file="$folder/munge.key" --socket="$folder/munge.socket" \
  --pid-file="$folder/munge.pid" --log-file="$folder/munge.log" --seed-file="$folder/munge.seed" \
  >"$folder/munged.out" 2>&1 &
daemons+=($!)

free_port() { python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])'; }
host=$(hostname -s)
cat >"$folder/slurm.conf" <<CONF
ClusterName=talus
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
CryptoType=crypto/munge
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=batch_sched_delay=0,sched_interval=1
ReturnToService=2
MpiDefault=none
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$host Default=YES State=UP
CONF
export SLURM_CONF=$folder/slurm.conf

slurmctld -D >"$folder/slurmctld.log" 2>&1 & daemons+=($!)
slurmd -D -f "$folder/slurm.conf" >"$folder/slurmd.log" 2>&1 & daemons+=($!)
for _ in $(seq 100); do
  sinfo --noheader --format=%T 2>/dev/null | grep --quiet idle && break
  sleep 0.2
done
sinfo --noheader --format=%T | grep --quiet idle || { tail -n 20 "$folder"/*.log; exit 1; }

study() { "$cli" study accuracy "$project" --axes body,time_step --values time_step=2,1 --size 800x500 "$@"; }
study --out "$folder/here"
study --out "$folder/there" --engine slurm

# All columns but seconds, and the front and what is chosen by them.
numbers() {
  python3 -c '
import csv, sys
for row in csv.DictReader(open(sys.argv[1])):
    print(*(f"{name}={value}" for name, value in row.items() if not name.endswith("seconds") and name not in ("pareto", "note")))
' "$1"
}
numbers "$folder/here/accuracy.csv" >"$folder/here.txt"
[[ $(wc -l <"$folder/here.txt") == 6 ]]
diff "$folder/here.txt" <(numbers "$folder/there/accuracy.csv")
[[ -s $folder/there/accuracy.png ]]

# Cases, too, of which one was lost with its node: it goes to Slurm by itself.
cat >"$folder/values.csv" <<'CSV'
case,/joints/J1/friction_angle
own,
steep,25
still,35
CSV
cases() { "$cli" study cases "$project" --table "$folder/values.csv" "$@"; }
cases --out "$folder/cases_here" --drop-results
cases --out "$folder/cases_there" --drop-results --engine slurm
rm "$folder/cases_there/runs/001.json"
cases --out "$folder/cases_there" --drop-results --engine slurm
diff <(numbers "$folder/cases_here/cases.csv") <(numbers "$folder/cases_there/cases.csv")
[[ $(wc -l <"$folder/cases_there/cases.csv") == 4 ]]
echo "The same numbers by both engines"
