//! Properties of a file besides its bytes: owner, permissions, attributes and other names.

pub(super) use system::{copy, has_other_names};

#[cfg(unix)]
mod system {
    use std::ffi::OsString;
    use std::fs::{File, Metadata};
    use std::io;
    use std::os::unix::fs::{MetadataExt, fchown};
    use std::path::Path;

    use xattr::FileExt;

    /// Whether the file has other names, hard links, which a new file would not have.
    pub(crate) fn has_other_names(found: &Metadata) -> bool {
        found.nlink() > 1
    }

    /// Gives the new file the owner, the permissions and the extended attributes of the file `path`. Access control
    /// lists are among the attributes.
    pub(crate) fn copy(path: &Path, found: &Metadata, new: &File) -> io::Result<()> {
        let owner = |file: &Metadata| (file.uid(), file.gid());
        if owner(&new.metadata()?) != owner(found) {
            fchown(new, Some(found.uid()), Some(found.gid()))?;
        }
        new.set_permissions(found.permissions())?;
        let old = File::open(path)?;
        let names = attributes(&old)?;
        for name in attributes(new)?.iter().filter(|name| !names.contains(name)) {
            new.remove_xattr(name)?;
        }
        for name in names {
            let value = old.get_xattr(&name)?.unwrap_or_default();
            // Some attributes exist on every new file and nobody may set them: equal values are left alone.
            if new.get_xattr(&name)?.as_ref() != Some(&value) {
                new.set_xattr(&name, &value)?;
            }
        }
        let now = new.metadata()?;
        match owner(&now) == owner(found) && now.mode() == found.mode() {
            true => Ok(()),
            false => Err(io::ErrorKind::PermissionDenied.into()),
        }
    }

    /// The names of a file's extended attributes; empty if its file system has no attributes.
    fn attributes(file: &File) -> io::Result<Vec<OsString>> {
        match file.list_xattr() {
            Ok(names) => Ok(names.collect()),
            Err(e) if e.kind() == io::ErrorKind::Unsupported => Ok(Vec::new()),
            Err(e) => Err(e),
        }
    }
}

#[cfg(not(unix))]
mod system {
    use std::fs::{File, Metadata};
    use std::io;
    use std::path::Path;

    pub fn has_other_names(_: &Metadata) -> bool {
        false
    }

    pub fn copy(_: &Path, found: &Metadata, new: &File) -> io::Result<()> {
        new.set_permissions(found.permissions())
    }
}
