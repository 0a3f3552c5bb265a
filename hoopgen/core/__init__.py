"""Files and folders: locks, folders that hoopgen owns, folders that only this user can change."""
