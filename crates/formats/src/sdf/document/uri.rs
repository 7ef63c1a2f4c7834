//! Files that `<include>` names.

use crate::meshes::files::MeshFolders;
use crate::reading::report::quoted;
use crate::reading::xml::text_of;
use crate::{DEFAULT_MAX_SIZE, SharedFiles, Source};
use std::path::{Path, PathBuf};

/// SDFormat file to which the `uri` in the file `including` refers, searched in the store `files`. If the URI is the folder of a library
/// model, its `model.config` names the file, or the file is `model.sdf`. The error names the paths that were tried and the remedy.
pub(crate) fn find_model_file(files: &SharedFiles, uri: &str, including: &Path) -> Result<PathBuf, String> {
    if uri.starts_with("https://") || uri.starts_with("http://") {
        return Err(format!(
            "the model {} is on a server, and nothing is downloaded; download it, and include it by its path",
            quoted(uri)
        ));
    }
    let folders = MeshFolders { files: files.clone(), ..MeshFolders::of_model(including, Vec::new()) };
    let mut candidates = folders.candidate_paths(uri);
    if !uri.contains("://") {
        // A name without a scheme may be that of a model of a library.
        candidates.extend(folders.candidate_paths(&format!("model://{uri}")));
    }
    if let Some(file) = candidates.iter().find(|path| files.is_file(path)) {
        return Ok(file.clone());
    }
    if let Some(folder) = candidates.iter().find(|path| files.is_folder(path)) {
        return model_in_folder(files, folder).ok_or_else(|| {
            format!(
                "the folder {} has no model.config that names an SDF file, and no model.sdf",
                quoted(&folder.to_string_lossy())
            )
        });
    }
    let tried: Vec<String> = candidates.iter().take(3).map(|path| quoted(&path.to_string_lossy())).collect();
    Err(format!(
        "the model {} does not exist; tried {}{}. Models are searched in the folders of GZ_SIM_RESOURCE_PATH, GAZEBO_MODEL_PATH and SDF_PATH, \
         beside the including file, and in the folders above it",
        quoted(uri),
        tried.join(", "),
        if candidates.len() > tried.len() { " and further folders" } else { "" }
    ))
}

/// SDF file of a model's folder: the one with the highest version in `model.config`, else `model.sdf`.
fn model_in_folder(files: &SharedFiles, folder: &Path) -> Option<PathBuf> {
    let named = configured_file(files, &folder.join("model.config")).map(|name| folder.join(name));
    named.into_iter().chain([folder.join("model.sdf")]).find(|path| files.is_file(path))
}

/// Name of the SDF file in a `model.config`: that of the highest version.
fn configured_file(files: &SharedFiles, config: &Path) -> Option<String> {
    // A pipe would wait for its other end.
    if !files.is_file(config) {
        return None;
    }
    let source = Source::read_from(files, &config.to_string_lossy(), DEFAULT_MAX_SIZE).ok()?;
    let text = std::str::from_utf8(&source.bytes).ok()?;
    let document = crate::reading::xml::parse(text, &mut crate::reading::report::Report::default())?;
    let files = document.descendants().filter(|node| node.has_tag_name("sdf"));
    let minor = |node: &roxmltree::Node<'_, '_>| {
        let version = node.attribute("version")?.strip_prefix("1.")?;
        version.parse::<u32>().ok()
    };
    let newest = files.max_by_key(|node| minor(node).unwrap_or(0))?;
    text_of(newest).map(|name| name.trim_ascii().to_owned())
}
