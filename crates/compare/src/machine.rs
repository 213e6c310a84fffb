//! Where and by what a result was made: absolute times mean nothing without it.

use serde::{Deserialize, Serialize};
use silhouette_render::AdapterDescription;

/// The machine, the adapter and the program of a run.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct RunDescription {
    /// Version of this package.
    pub version: String,
    /// Commit that the program was built from, with `-dirty` where the tree had changes; empty where there was no
    /// repository.
    pub commit: String,
    /// Compiler that built the program.
    pub rustc: String,
    /// `debug` or `release`: whether assertions were on.
    pub build: String,
    /// Processor model, as the operating system names it.
    pub cpu: String,
    /// Hardware threads that the process may use.
    pub threads: usize,
    /// Operating system and architecture.
    pub system: String,
    /// Graphics adapter.
    pub adapter: AdapterRecord,
}

/// The adapter that drew.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct AdapterRecord {
    /// Name of the device.
    pub name: String,
    /// Driver with its version.
    pub driver: String,
    /// Graphics API.
    pub backend: String,
    /// Whether the device is the processor itself.
    pub software: bool,
    /// Whether passes could be timed by the device's clock.
    pub timestamps: bool,
}

impl From<&AdapterDescription> for AdapterRecord {
    fn from(adapter: &AdapterDescription) -> Self {
        Self {
            name: adapter.name.clone(),
            driver: adapter.driver.clone(),
            backend: adapter.backend.clone(),
            software: adapter.software,
            timestamps: adapter.timestamps,
        }
    }
}

impl RunDescription {
    /// This process on this machine, drawing with `adapter`.
    pub fn of_this_process(adapter: &AdapterDescription) -> Self {
        let MachineFacts { cpu, threads, system } = MachineFacts::of_this_machine();
        Self {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            commit: env!("SILHOUETTES_COMMIT").to_owned(),
            rustc: env!("SILHOUETTES_RUSTC").to_owned(),
            build: BUILD.to_owned(),
            cpu,
            threads,
            system,
            adapter: adapter.into(),
        }
    }

    /// The facts with their names, for people.
    pub fn facts(&self) -> Vec<(&'static str, String)> {
        let adapter = &self.adapter;
        let kind = if adapter.software { "software" } else { "hardware" };
        let clock = if adapter.timestamps { "with timestamps" } else { "without timestamps" };
        let or_unknown = |text: &str| if text.is_empty() { "unknown".to_owned() } else { text.to_owned() };
        vec![
            ("Processor", format!("{}, {} threads", self.cpu, self.threads)),
            ("System", self.system.clone()),
            ("Adapter", format!("{} ({kind}, {}, {clock})", adapter.name, adapter.backend)),
            ("Driver", or_unknown(&adapter.driver)),
            (
                "Program",
                format!("silhouettes {}, {} build, commit {}", self.version, self.build, or_unknown(&self.commit)),
            ),
            ("Compiler", or_unknown(&self.rustc)),
        ]
    }
}

/// This machine in one line, for results that no adapter has a part in: processor, hardware threads, system.
pub fn describe_machine() -> String {
    MachineFacts::of_this_machine().to_string()
}

/// This program in one line: version, build, commit where it is known, compiler.
pub fn describe_program() -> String {
    let [version, commit, rustc] =
        [env!("CARGO_PKG_VERSION"), env!("SILHOUETTES_COMMIT"), env!("SILHOUETTES_RUSTC")].map(str::to_owned);
    let commit = if commit.is_empty() { commit } else { format!(", commit {commit}") };
    format!("silhouettes {version}, {BUILD} build{commit}, {rustc}")
}

/// Version and commit of this program.
pub(crate) fn program() -> [String; 2] {
    [env!("CARGO_PKG_VERSION"), env!("SILHOUETTES_COMMIT")].map(str::to_owned)
}

/// Whether assertions are on.
const BUILD: &str = if cfg!(debug_assertions) { "debug" } else { "release" };

/// What is known without an adapter.
pub(crate) struct MachineFacts {
    pub cpu: String,
    pub threads: usize,
    pub system: String,
}

impl std::fmt::Display for MachineFacts {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { cpu, threads, system } = self;
        write!(f, "{cpu}, {threads} threads, {system}")
    }
}

impl MachineFacts {
    fn of_this_machine() -> Self {
        Self {
            cpu: cpu_model(&read("/proc/cpuinfo")).unwrap_or("unknown").to_owned(),
            threads: std::thread::available_parallelism().map_or(1, usize::from),
            system: system_name(&read("/etc/os-release")),
        }
    }
}

/// Contents of a file of the operating system; empty where it does not exist.
fn read(path: &str) -> String {
    std::fs::read_to_string(path).unwrap_or_default()
}

fn cpu_model(cpuinfo: &str) -> Option<&str> {
    let fields = cpuinfo.lines().filter_map(|line| line.split_once(':'));
    fields
        .map(|(name, value)| (name.trim(), value.trim()))
        .find(|(name, _)| *name == "model name")
        .map(|(_, value)| value)
}

fn system_name(os_release: &str) -> String {
    let pretty = os_release.lines().find_map(|line| line.strip_prefix("PRETTY_NAME="));
    let name = pretty.map_or(std::env::consts::OS, |name| name.trim_matches('"'));
    format!("{name}, {}", std::env::consts::ARCH)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_of_the_system_are_read_where_they_exist() {
        assert_eq!(cpu_model("processor : 0\nmodel name\t: Xeon: fast\nmodel name : other"), Some("Xeon: fast"));
        assert_eq!(cpu_model(""), None);
        assert!(system_name("ID=x\nPRETTY_NAME=\"A Linux 1\"\n").starts_with("A Linux 1, "));
        assert!(system_name("").starts_with(std::env::consts::OS));
    }
}
