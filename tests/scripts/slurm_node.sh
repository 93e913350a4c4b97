#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# usage: slurm_node.sh FOLDER CMD...     starts a Slurm cluster of this machine alone in FOLDER, runs CMD on it, ends it.
# 77: there is no Slurm here or it does not start (its words go to standard error).
set -euo pipefail
folder=${1:?folder}
shift
for program in munged slurmctld slurmd sbatch; do
  command -v "$program" >/dev/null || PATH=$PATH:/usr/sbin command -v "$program" >/dev/null || { echo "no $program" >&2; exit 77; }
done
export PATH=$PATH:/usr/sbin SLURM_CONF=$folder/slurm.conf
[ "$(id -u)" = 0 ] || { echo "slurmd starts as root alone" >&2; exit 77; }
mkdir -p "$folder"/{spool,state}
node=$(hostname -s) user=$(id -un)
port=$((20000 + RANDOM % 20000))
cat >"$folder/slurm.conf" <<CONF
ClusterName=one
SlurmctldHost=$node(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
CryptoType=crypto/munge
CredType=cred/munge
SlurmUser=$user
SlurmdUser=$user
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SchedulerType=sched/backfill
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_min_interval=100000,batch_sched_delay=0
MpiDefault=none
ReturnToService=2
MailProg=/bin/true
NodeName=$node NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=$node Default=YES MaxTime=INFINITE State=UP
CONF
sed -i '/^CryptoType/d' "$folder/slurm.conf"
pids=()
end() {
  # what was started here, by its number
  for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null || true; done
  wait 2>/dev/null || true
}
trap end EXIT
dd if=/dev/urandom of="$folder/munge.key" bs=128 count=1 status=none
chmod 700 "$folder"
chmod 400 "$folder/munge.key"
munged --foreground --force --key-file="$folder/munge.key" --socket="$folder/munge.socket" --pid-file="$folder/munge.pid" \
  --log-file="$folder/munge.log" --seed-file="$folder/munge.seed" >"$folder/munge.out" 2>&1 &
pids+=($!)
for _ in $(seq 50); do [ -S "$folder/munge.socket" ] && break; sleep 0.1; done
slurmctld -D >"$folder/slurmctld.out" 2>&1 &
pids+=($!)
slurmd -D -N "$node" >"$folder/slurmd.out" 2>&1 &
pids+=($!)
for _ in $(seq 150); do
  [ "$(sinfo -h -o %T 2>/dev/null)" = idle ] && ready=1 && break
  sleep 0.2
done
if [ -z "${ready:-}" ]; then
  tail -n 5 "$folder"/*.log "$folder"/*.out >&2 || true
  exit 77
fi
"$@"
