#!/bin/sh
# Slurm on this machine alone, for as long as one array of jobs takes: controller and node as root, as a container or a virtual machine has
# it. Needs Debian's slurm-wlm and munge.
#
#   docs/sweeps/slurm-here.sh N CELLS [MESH...] [OPTIONS OF silhouettes compare]
set -eu
root=$(cd "$(dirname "$0")" && pwd)
count=$1 cells=$2
shift 2
work=$(mktemp -d)
host=$(hostname)
cores=$(nproc)
cat > "$work/slurm.conf" <<EOF
ClusterName=here
SlurmctldHost=$host
SlurmUser=root
AuthType=auth/munge
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
SlurmctldPort=36817
SlurmdPort=36818
ReturnToService=2
SchedulerParameters=sched_interval=2
NodeName=$host CPUs=$cores State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
EOF
mkdir "$work/state" "$work/spool"
export SLURM_CONF="$work/slurm.conf"
own_munge=
if ! munge -n > /dev/null 2>&1; then
    [ -s /etc/munge/munge.key ] || mungekey --create --keyfile /etc/munge/munge.key
    mkdir -p /run/munge && chown munge: /run/munge /etc/munge/munge.key
    su -s /bin/sh munge -c "/usr/sbin/munged --force"
    own_munge=yes
fi
stop() {
    for daemon in slurmd slurmctld; do
        [ -s "$work/$daemon.pid" ] && kill "$(cat "$work/$daemon.pid")" 2> /dev/null || true
    done
    [ -n "$own_munge" ] && su -s /bin/sh munge -c "/usr/sbin/munged --stop" 2> /dev/null || true
    rm -r "$work"
}
trap stop EXIT
slurmctld
slurmd
tries=0
until sinfo --noheader --format=%t 2> /dev/null | grep -q idle; do
    tries=$((tries + 1))
    if [ "$tries" -gt 60 ]; then
        tail -n 5 "$work"/*.log >&2
        exit 1
    fi
    sleep 1
done
sbatch --wait --array="0-$((count - 1))" --export=ALL "$root/slurm.sbatch" "$cells" "$@"
