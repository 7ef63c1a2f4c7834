//! With the feature `engine`: builds the WebAssembly module of `percuss-web` and compresses it, for the page to contain it.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    #[cfg(feature = "engine")]
    if let Err(error) = engine::build() {
        println!("cargo::error={error}");
        // With a failed script, cargo also shows the messages of the programs that it has run.
        std::process::exit(1);
    }
}

#[cfg(feature = "engine")]
mod engine {
    use lzma_rust2::{LzmaOptions, LzmaWriter};
    use std::collections::BTreeSet;
    use std::env::{home_dir, var_os, vars_os};
    use std::error::Error;
    use std::ffi::OsString;
    use std::fs;
    use std::io::Write;
    use std::path::{Path, PathBuf};
    use std::process::Command;

    const TRIPLE: &str = "wasm32-unknown-unknown";

    /// Arguments of the nested cargo. Only as a cdylib: cargo leaves out the link-time optimisation of a crate that is an rlib as well.
    const CARGO: &str = "rustc --locked --profile web -p percuss-web --crate-type cdylib --target";

    /// Beginnings of the names of the variables of cargo that the nested cargo receives: registries, network, and the limit of
    /// processes; and changes of its profile. Flags, other profiles, targets and wrappers of the outer build would change the module.
    const PASSED_ON: [&str; 7] = [
        "CARGO_HOME",
        "CARGO_HTTP_",
        "CARGO_MAKEFLAGS",
        "CARGO_NET_",
        "CARGO_PROFILE_WEB_",
        "CARGO_REGISTR",
        "CARGO_SOURCE_",
    ];

    /// Folder of this machine whose name the compiler would write into the module.
    struct MachineFolder {
        path: PathBuf,
        /// Folder in it from which files are compiled.
        sources: &'static str,
        /// Name in the module, the same on every machine.
        name: &'static str,
    }

    /// Writes `percuss.wasm.lzma` into the output folder of the build script.
    pub fn build() -> Result<(), Box<dyn Error>> {
        let here = PathBuf::from(variable("CARGO_MANIFEST_DIR")?);
        let root = here.ancestors().nth(2).filter(|root| root.join("crates/web/Cargo.toml").exists()).ok_or(
            "the engine of the explorer is built in a clone of the repository: \
             `cargo run --release --features explorer -- explore models/four_bar.urdf`",
        )?;
        require_standard_library()?;
        let folders = machine_folders(root)?;
        let out = PathBuf::from(variable("OUT_DIR")?);
        let target_folder = engine_folder(&out)?;
        compile(root, &target_folder, &folders)?;
        let built = target_folder.join(TRIPLE).join("web");
        watch_sources(root, &built.join("percuss_web.d"))?;
        let module = fs::read(built.join("percuss_web.wasm"))?;
        for MachineFolder { path, sources, .. } in folders {
            let path = path.join(sources).to_string_lossy().into_owned();
            if module.windows(path.len()).any(|bytes| bytes == path.as_bytes()) {
                return Err(format!("the engine of the explorer contains the path {path}").into());
            }
        }
        Ok(fs::write(out.join("percuss.wasm.lzma"), compress(&module)?)?)
    }

    /// Variable that cargo sets for build scripts.
    fn variable(name: &str) -> Result<OsString, String> {
        var_os(name).ok_or_else(|| format!("cargo has not set {name}"))
    }

    /// Path that the compiler of the outer build prints.
    fn path_of_rustc(arguments: &str) -> Result<PathBuf, Box<dyn Error>> {
        let output = Command::new(variable("RUSTC")?).arg("--print").args(arguments.split(' ')).output()?;
        Ok(String::from_utf8(output.stdout)?.trim().into())
    }

    /// Adds the standard library for WebAssembly to the toolchain if it is missing. A file rust-toolchain.toml that names the target is no
    /// replacement: with it, any cargo command in this repository updates the default toolchain, and fails without a network.
    fn require_standard_library() -> Result<(), Box<dyn Error>> {
        let folder = path_of_rustc(&format!("target-libdir --target {TRIPLE}"))?;
        // Set by rustup. In a build by another toolchain, rustup would add the target to the wrong one.
        if !folder.is_dir() && var_os("RUSTUP_TOOLCHAIN").is_some() {
            // Its errors are on stderr; the folder is examined again below.
            let _ = Command::new("rustup").args(["target", "add", TRIPLE]).status();
        }
        if folder.is_dir() {
            return Ok(());
        }
        let message = format!(
            "the explorer needs the standard library of Rust for {TRIPLE}: `rustup target add {TRIPLE}`; \
             for the cargo of Debian: `apt install libstd-rust-dev-wasm32`"
        );
        Err(message.into())
    }

    fn machine_folders(root: &Path) -> Result<[MachineFolder; 3], Box<dyn Error>> {
        let cargo_home = var_os("CARGO_HOME").map(PathBuf::from).or_else(|| Some(home_dir()?.join(".cargo")));
        Ok([
            MachineFolder { path: root.to_path_buf(), sources: "crates", name: "percuss" },
            MachineFolder { path: cargo_home.ok_or("no home folder")?, sources: "registry", name: "cargo" },
            MachineFolder { path: path_of_rustc("sysroot")?, sources: "lib", name: "rust" },
        ])
    }

    /// Target folder of the nested cargo, the same for all profiles and targets of the outer build. The outer cargo locks its own.
    fn engine_folder(out: &Path) -> Result<PathBuf, Box<dyn Error>> {
        // TARGET_FOLDER/[TRIPLE/]PROFILE/build/PACKAGE/out
        let folder = out.ancestors().nth(4).ok_or("OUT_DIR is not in a target folder")?;
        let folder =
            if folder.ends_with(variable("TARGET")?) { folder.parent().unwrap_or(folder) } else { folder };
        Ok(folder.join("explorer-engine"))
    }

    fn compile(root: &Path, target_folder: &Path, folders: &[MachineFolder]) -> Result<(), Box<dyn Error>> {
        let mut cargo = Command::new(variable("CARGO")?);
        for name in vars_os().filter_map(|(name, _)| name.into_string().ok()) {
            let of_rust =
                name.starts_with("CARGO") || name.starts_with("RUST") && !name.starts_with("RUSTUP_");
            if of_rust && !PASSED_ON.iter().any(|kept| name.starts_with(kept)) {
                cargo.env_remove(name);
            }
        }
        let remap = |MachineFolder { path, name, .. }: &MachineFolder| {
            format!("--remap-path-prefix={}={name}", path.display())
        };
        let flags = folders.iter().map(remap).collect::<Vec<_>>().join("\u{1f}");
        cargo.env("RUSTC", variable("RUSTC")?).env("CARGO_ENCODED_RUSTFLAGS", flags);
        cargo.env("CARGO_TARGET_DIR", target_folder).env("CARGO_BUILD_BUILD_DIR", target_folder);
        if cargo.args(CARGO.split(' ')).arg(TRIPLE).current_dir(root).status()?.success() {
            return Ok(());
        }
        Err("cargo cannot build the engine of the explorer: see its messages".into())
    }

    /// Lets cargo run this script again after a change of the lock file, of a source of the module (its dep-info lists all of them), or of
    /// a manifest.
    fn watch_sources(root: &Path, dep_info: &Path) -> Result<(), Box<dyn Error>> {
        let text = fs::read_to_string(dep_info)?;
        let (_, sources) = text.split_once(": ").ok_or("the dep-info lists no sources")?;
        let sources = sources.replace("\\ ", "\0");
        let sources = sources.split_whitespace().map(|path| PathBuf::from(path.replace('\0', " ")));
        let mut watched = BTreeSet::from([root.join("Cargo.lock")]);
        for source in sources {
            watched.extend(source.ancestors().map(|folder| folder.join("Cargo.toml")));
            watched.insert(source);
        }
        for path in watched.iter().filter(|path| path.exists()) {
            println!("cargo::rerun-if-changed={}", path.display());
        }
        Ok(())
    }

    /// Content of an .lzma file, as of `xz -9e`. It is a fifth smaller than gzip; the page decodes it in a third of a second.
    fn compress(module: &[u8]) -> std::io::Result<Vec<u8>> {
        let options =
            LzmaOptions { nice_len: LzmaOptions::NICE_LEN_MAX, depth_limit: 512, ..LzmaOptions::default() };
        let mut writer = LzmaWriter::new_use_header(Vec::new(), &options, Some(module.len() as u64))?;
        writer.write_all(module)?;
        writer.finish()
    }
}
